// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/sets/highest_points.h"
#include "raygauge/numerics/dense.h"

namespace raygauge {

/// A tree of clusters of N points of R^n, which tells a search for the highest points which blocks of points
/// (PointSet) it can leave out.
///
/// With p = c + F y + δ, F the map that brings the points into isotropic position, w = Fᵀu, and a cluster
/// whose points have d·y in [low, high] and |y - (d·y) d| <= r (|d| = 1; a cylinder about a ray from c),
///
///     u·p <= u·c + (d·w > 0 ? high : low) d·w + r √(|w|² - (d·w)²) + u·δ.
///
/// A cluster is left out only where this bound, with an allowance for all rounding errors, is below what was
/// found: the answer is that of a pass over all points, bit by bit.
class ClusterTree {
 public:
  using Points = Eigen::Ref<const Eigen::MatrixXd>;

  /// Points in more dimensions, and fewer numbers N n, have no tree: a pass is as fast.
  static constexpr int kMostDimensions = 32;

  using Order = std::vector<std::ptrdiff_t>;

  /// The tree of `points`, n × N and finite, and the `order` of the points in which clusters are whole
  /// blocks; `blocks` below are those of the points in this order. Empty for points without a tree, and where
  /// squares of coordinates leave the range of doubles.
  ClusterTree(const Points& points, Order& order);

  bool empty() const noexcept { return nodes_.empty(); }

  /// max_i u·p_i; the index counts the lanes of the blocks, the last ones being copies of the last point.
  Highest highest(const Kernels& kernels, const double* blocks, const double* u) const;

  /// max_i u·p_i, and the points above a threshold, as Kernels::collect.
  double collect(const Kernels& kernels, const double* blocks, const double* u, Collection& found) const;

  /// Whether searches leave out enough to be worth their bounds, along a few directions.
  bool pays(const double* blocks) const;

  /// Bytes.
  std::ptrdiff_t memory() const noexcept;

 private:
  static constexpr int kChildren = 8;  // as many as a block has lanes
  using Children = std::array<double, kChildren>;

  // Eight clusters; their axes d stand in axes_ as a block of points.
  struct Node {
    Children low{}, high{}, radius{};
    std::array<std::int32_t, kChildren> first{};   // block of a leaf, node of any other
    std::array<std::int32_t, kChildren> blocks{};  // of a leaf; of any other 0
    int count = 0;
  };
  class Builder;
  struct Query;

  Query query(const Kernels& kernels, const double* u) const;
  Children bounds(const Query& query, std::int32_t node) const;

  // leaf(first, last) reads blocks and returns the height below which nothing is looked for any more.
  template <class Leaf>
  void search(const Query& query, std::int32_t node, double& height, const Leaf& leaf) const;

  int n_ = 0;
  std::ptrdiff_t block_count_ = 0;
  std::vector<Node> nodes_;
  AlignedBuffer<double> axes_;  // n × kChildren numbers a node
  Vector center_;               // c
  DenseMatrix map_;             // F
  DenseMatrix inverse_;
  Vector slack_;  // Σ_k |u_k| slack_k is allowed for rounding errors and δ
};

}  // namespace raygauge
