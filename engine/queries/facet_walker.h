// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/queries/facet_walks.h"

namespace raygauge {

/// Facets that were found near each other, for walks to begin at: inverses of bases, in single precision.
class KnownFacets {
 public:
  void clear(int n);

  /// That of the walk, while there is room.
  void add(const FacetWalk& walk);

  /// The facet whose plane x (n doubles) is farthest beyond, to where the walk keeps it.
  void load_best(const Kernels& kernels, const double* x, FacetWalk* walk) const;

 private:
  static constexpr int kMost = 256;

  int n_ = 0, count_ = 0;
  AlignedBuffer<float> inverses_;    // n + 1 columns of 16: R, and y
  AlignedBuffer<std::int32_t> ids_;  // n each
  AlignedBuffer<double> normals_;    // y, in blocks of 8
};

/// The walks of one thread.
class FacetWalker {
 public:
  explicit FacetWalker(const WalkedPoints& points);

  /// Begins a group at a facet, by the normal of its plane, w·p <= 1. False where the plane does not hold n
  /// independent points, or their matrix cannot be inverted.
  bool begin(const Vector& facet_normal);

  /// The gauge at x (n doubles), and the normal of a plane that bounds it, if there is room.
  WalkAnswer gauge(const double* x, double* normal);

 private:
  void sort_points(const Vector& normal);
  std::vector<std::int32_t> points_in_plane() const;
  WalkEnd walk();
  void adapt_share();
  std::ptrdiff_t blocks_in_reach() const;
  void bound_support();
  WalkAnswer bounds() const;
  Eigen::Map<const Eigen::VectorXd> point_at(std::ptrdiff_t place) const {
    const std::ptrdiff_t i = order_[static_cast<std::size_t>(place)];
    return {all_->rows.data() + i * WalkedPoints::kRow, all_->n};
  }

  const WalkedPoints* all_;
  std::ptrdiff_t block_count_;
  KnownFacets known_;
  FacetWalk walk_;
  Vector normal_;                      // of the group's facet, for the points as they are walked
  AlignedBuffer<double> reach_;        // w·p of all points,
  AlignedBuffer<std::int32_t> order_;  // by which they are sorted, falling: their numbers
  AlignedBuffer<float> blocks_;
  std::vector<double> tops_;  // of each block and those behind: max w·p
  AlignedBuffer<float> columns_, costs_, along_;
  AlignedBuffer<std::int32_t> places_, ids_;
  AlignedBuffer<float> small_;       // R, y, x, b
  AlignedBuffer<double> doubles_;    // b, and what the walk found
  std::vector<std::int64_t> found_;  // by a pass: points near the plane or beyond
  std::vector<double> values_;
  std::vector<std::int32_t> beyond_;
  float share_ = 0;     // FacetWalk::share_of_highest, for some number of columns
  double support_ = 1;  // at least max y·p
};

}  // namespace raygauge
