// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/threads/chunk_team.h"
#include "engine/threads/shared_tools.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Proven bounds of the gauge of a set at one point.
struct WalkAnswer {
  double lower = 0;
  double upper = 0;
  bool closed = false;  ///< within the tolerance; the other values say nothing without
};

/// The points of a set as walks read them: times a power of two, so that all have length 1 at most.
struct WalkedPoints {
  static constexpr int kRow = 16;  ///< numbers a point, the last ones 0
  static constexpr double kScale = 0x1p14;

  /// `gauge_of_axes`: at least max(gauge(e_k), gauge(-e_k)).
  WalkedPoints(const PointSet& S, const Vector& gauge_of_axes, double tolerance, const Kernels& kernels);

  const Kernels* kernels;
  const PointSet* S;
  int n;
  double tolerance;
  double factor = 1;                  ///< that power
  bool usable = false;                ///< few coordinates, in the range of single precision
  AlignedBuffer<double> rows;         ///< the points, times that power
  AlignedBuffer<std::int32_t> pairs;  ///< these times kScale, rounded, each two in one number
  Vector magnitude;                   ///< max_i |p_ik|, times that power
  Vector axis_gauge;                  ///< by that power
};

/// Two numbers below 2^15, rounded, in one.
inline std::int32_t pair_of(double low, double high) {
  const auto half = [](double x) {
    return static_cast<std::uint16_t>(static_cast<int>(x < 0 ? x - 0.5 : x + 0.5));
  };
  return static_cast<std::int32_t>(half(low) | static_cast<std::uint32_t>(half(high)) << 16);
}

class FacetWalker;

/// Gauges of a hull of points at many points, by walks from facet to facet. Points are asked in groups, each
/// about a facet that a solve has found; within a group each point starts from that of the facets found
/// before it whose plane it is farthest beyond, and the dual simplex walks over those of the set's points
/// that are near. Of the last facet it is proven, by a pass in integers over what may reach its plane (in
/// single precision where its normal is long) and by products in double, that no point is beyond; those that
/// are join the others, and the primal simplex goes on. Several points are walked at once, and share passes.
/// A group is walked on one thread, so that answers do not depend on their number.
class FacetWalks {
 public:
  /// `gauge_of_axes` as in WalkedPoints.
  FacetWalks(const PointSet& S, const Vector& gauge_of_axes, double tolerance, int threads,
             const Kernels& kernels = best_kernels());
  ~FacetWalks();

  /// Whether the set has few coordinates and many points.
  static bool suits(const PointSet& S) noexcept;

  /// Whether the points suit: of few coordinates, not too far apart in size, and their lists shorter.
  bool usable() const noexcept { return points_.usable; }

  /// How many facets there should be for a number of points, and how many there are.
  static std::ptrdiff_t facets_for(std::size_t points) noexcept;
  std::ptrdiff_t facets() const noexcept { return std::ssize(normals_); }

  /// A facet of S by the normal of its plane, of any length.
  void add_facet(const Vector& normal);

  /// The gauges at X's columns `which`, and normals, n doubles each, where there is room. Those that a stop
  /// left out are not closed.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& X, std::span<const std::size_t> which,
             const std::function<bool()>& stop, std::span<WalkAnswer> answers, std::span<double> normals);

 private:
  void sort_by_group(const Eigen::Ref<const Eigen::MatrixXd>& X, std::span<const std::size_t> which);

  WalkedPoints points_;
  std::vector<Vector> normals_;        // w of the facets, with w·p <= 1
  AlignedBuffer<float> blocks_;        // of them, in single precision
  std::vector<std::size_t> first_;     // of each group among
  std::vector<std::size_t> by_group_;  // positions in `which`
  std::vector<std::size_t> group_of_;
  ChunkTeam team_;
  SharedTools<std::unique_ptr<FacetWalker>> walkers_;  // each made when it is first lent
};

}  // namespace raygauge
