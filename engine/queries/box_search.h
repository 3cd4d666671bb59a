// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/numerics/stopwatch.h"
#include "engine/queries/mesh_pair.h"
#include "engine/queries/nearest_triangles.h"

namespace raygauge {

/// The search for the triangle that is nearest to a body or a half-space, and for those of two meshes whose
/// sizes are beyond the range of single precision: pairs of boxes one by one, in double, depth first, the
/// nearer one first.
class BoxSearch {
 public:
  explicit BoxSearch(const Stopwatch& watch);

  void search(const MeshPair& pair, NearestTriangles& nearest);

 private:
  struct OpenPair {
    std::int32_t one, two;
    double lower;
  };

  bool is_over(const OpenPair& pair);
  void push(std::int32_t one, std::int32_t two);
  void expand(const OpenPair& pair);
  void look_at_leaves(const BoxNode& one, const BoxNode& two);
  double box_distance(const BoxNode& one, const BoxNode& two) const noexcept;

  const Stopwatch* watch_;
  const MeshPair* pair_ = nullptr;
  NearestTriangles* nearest_ = nullptr;
  std::vector<OpenPair> open_;
  std::int64_t looks_ = 0;
};

}  // namespace raygauge
