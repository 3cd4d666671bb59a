// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/queries/facet_walks.h"
#include "engine/queries/point_walk.h"

namespace raygauge {

/// Facets that were found near each other, for walks to begin at: inverses of bases, in single precision.
class KnownFacets {
 public:
  void clear(int n);

  /// That of the walk, while there is room.
  void add(const FacetWalk& walk);

  FacetList list() const { return {normals_.data(), inverses_.data(), ids_.data(), count_}; }

 private:
  static constexpr int kMost = 256;

  int n_ = 0, count_ = 0;
  AlignedBuffer<float> inverses_;    // n + 1 columns of 16: R, and y
  AlignedBuffer<std::int32_t> ids_;  // n each
  AlignedBuffer<float> normals_;     // y, in blocks of 16
};

/// The walks of one thread.
class FacetWalker {
 public:
  explicit FacetWalker(const WalkedPoints& points);

  /// Begins a group at a facet, by the normal of its plane, w·p <= 1. False where the plane does not hold n
  /// independent points, or their matrix cannot be inverted.
  bool begin(const Vector& facet_normal);

  /// Answers questions, several at once.
  void solve(std::span<const WalkQuestion> questions);

 private:
  void sort_points(const Vector& normal);
  void fill_blocks(std::ptrdiff_t count);
  void fill_rounded(std::ptrdiff_t count);
  std::vector<std::int32_t> points_in_plane() const;
  void walk();
  void walk_farther();
  void look_beyond();
  std::ptrdiff_t blocks_in_reach(const FacetWalk& walk) const;
  Eigen::Map<const Eigen::VectorXd> point_at(std::ptrdiff_t place) const {
    const std::ptrdiff_t i = order_[static_cast<std::size_t>(place)];
    return {all_->rows.data() + i * WalkedPoints::kRow, all_->n};
  }

  const WalkedPoints* all_;
  std::ptrdiff_t block_count_;
  KnownFacets known_;
  FacetWalkPoints group_;
  std::vector<std::unique_ptr<PointWalk>> walks_;
  std::vector<PointWalk*> idle_;         // of them: those without a question,
  std::vector<PointWalk*> begun_;        // those at its beginning,
  std::vector<PointWalk*> arrived_;      // and those that wait for a pass
  Vector normal_;                        // of the group's facet, for the points as they are walked
  AlignedBuffer<double> reach_;          // w·p of all points,
  AlignedBuffer<std::int32_t> order_;    // by which they are sorted, falling: their numbers
  std::ptrdiff_t highest_ = 0;           // so many are in the first bucket, all in the plane among them
  AlignedBuffer<float> blocks_;          // in this order, ...
  AlignedBuffer<std::int32_t> rounded_;  // ... and rounded to integers, in pairs
  std::ptrdiff_t blocks_filled_ = 0, rounded_filled_ = 0;
  std::vector<double> tops_;  // of each block and those behind: max w·p
  float share_ = 0;           // FacetWalkPoints::share_of_highest, for some number of columns
};

}  // namespace raygauge
