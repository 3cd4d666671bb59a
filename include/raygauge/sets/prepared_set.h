// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "raygauge/sets/point_set.h"

namespace raygauge {

class DirectionTable;

/// conv{p_1, …, p_N}, prepared once for many queries; immutable and shared between threads.
///
/// In R^3 a DirectionTable lists, for each small cell of directions, the few points that can be highest
/// there: a support query of fixed-size code compares these alone, and its answer is proven. Where the
/// library is built with Qhull and the points are not flat, points deep inside the hull are dropped, and a
/// ball inside it is known.
///
/// In R^n a tree of clusters with proven bounds lets a support query read few of the points. It pays for tens
/// of thousands of points in few dimensions; elsewhere this is a PointSet of the same points.
///
/// The answer is that of a PointSet of the same points: the maximum over all of them, to rounding.
class PreparedSet final : public ConvexSet {
 public:
  /// `points` is n × N, one point a column. Throws as PointSet does.
  explicit PreparedSet(const Eigen::Ref<const Eigen::MatrixXd>& points);
  explicit PreparedSet(const PointSet& points);

  /// Whether this build has hulls with adjacency.
  static bool has_hulls() noexcept;

  /// The points that were kept, in their order. Indices in results count these.
  const PointSet& points() const noexcept { return *points_; }

  /// Vertices of the hull; 0 where Qhull did not find it.
  std::ptrdiff_t vertex_count() const noexcept { return vertex_count_; }

  /// Bytes that this set holds.
  std::ptrdiff_t memory() const noexcept;

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return points_->smooth(); }

  void keep(const Eigen::Ref<const Eigen::MatrixXd>& points);

  std::unique_ptr<const PointSet> points_;
  Vector center_;            // of all points given
  double inner_radius_ = 0;  // about it
  double extent_ = 0;
  std::ptrdiff_t vertex_count_ = 0;
  std::shared_ptr<const DirectionTable> table_;  // for n = 3
};

}  // namespace raygauge
