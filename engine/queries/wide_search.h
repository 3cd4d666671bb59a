// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/stopwatch.h"
#include "engine/queries/mesh_pair.h"
#include "engine/queries/nearest_triangles.h"

namespace raygauge {

/// The search for the nearest triangles of two meshes, eight boxes and sixteen pairs of triangles at once, in
/// single precision, depth first, the nearest one first. What is not beyond the target then is looked at in
/// double.
class WideSearch {
 public:
  WideSearch(const Kernels& kernels, const Stopwatch& watch);

  void search(const MeshPair& pair, NearestTriangles& nearest);

 private:
  /// Boxes, by their numbers and as WideNode has them.
  struct OpenPair {
    std::int32_t one, two, wide_one, wide_two;
    float lower;
  };

  /// A triangle of a block, and how far it is from the box of another, at least.
  struct BlockLane {
    int lane;
    float lower;
  };

  struct Placed {
    std::int32_t node = -1;
    PlacedBox box{};
  };

  void begin();
  bool is_over(const OpenPair& pair);
  float beyond() const noexcept;
  const PlacedBox& place_first(std::int32_t one);
  const PlacedBox& place_second(std::int32_t two);
  void open(const OpenPair& pair);
  void push_near(const OpenPair& pair, const WideNode& node, unsigned lanes, const float* lower,
                 bool of_first);
  void look_at_blocks(const OpenPair& pair);
  int near_of_block(const OpenPair& pair, bool of_first, BlockLane* near);
  void add_lane(const TriangleBlock& one, int i, const TriangleBlock& two, int k);
  void look_at_lanes();

  const Kernels* kernels_;
  const Stopwatch* watch_;
  const MeshPair* pair_ = nullptr;
  NearestTriangles* nearest_ = nullptr;
  std::vector<OpenPair> open_;
  std::int64_t looks_ = 0;
  Matrix3 back_R_;  // first frame to second
  Vector3 back_t_;
  Placed placed_[2];       // the last boxes of both meshes that others were compared with
  TriangleLanes lanes_{};  // pairs of triangles that are to be looked at ...
  std::int32_t lane_one_[TriangleLanes::kCount], lane_two_[TriangleLanes::kCount];  // ... their numbers
  int lane_count_ = 0;
};

}  // namespace raygauge
