// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/methods/spatial/spatial_pair.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {

/// A half-space H = {x : n·x <= b} and a body K, in poses. H in the pose (R, t) is {y : m·(y - t) <= b} with
/// m = R⁻ᵀn, and with the gap
///
///     g = min over K of m·(y - t) - b = -h_K(-m) - m·t - b,
///
/// from one support query of K, everything about H and K has a closed form: see HalfSpace. R⁻ᵀ is Rᵀ but for
/// the defect δ of the pose; what it may change of g is bounded by |R⁻ᵀn - m| max |y - t| over K.
/// Doubles first; for bodies with fixed-size code double-double arithmetic where the tolerance asks for it.
class HalfSpaceQuery {
 public:
  /// False if neither is a half-space. Both must outlive the queries. Throws InvalidParameterError if both
  /// are, DimensionMismatchError if they live in different spaces.
  bool bind(const Posed& first, const Posed& second);

  /// Throws DimensionMismatchError.
  void distance(const ConvexSet& Q, const DistanceOptions& options, ObjectEffects effects,
                ObjectDistance& result);

  Separation separation(const DistanceOptions& options);

  /// A lower bound on the distance, 0 where there is none; doubles alone.
  double lower_bound(const ConvexSet& Q) const;

  /// A lower bound on g, after a query.
  double gap_lower() const noexcept { return gap_lower_; }

  /// ±m, a normal that leads from the second object to the first, and the point of K that is lowest.
  const Vector& direction() const noexcept { return direction_; }
  const Vector& point() const noexcept { return point_; }

  std::int64_t support_queries() const noexcept { return support_queries_; }

 private:
  /// h_Q in a direction: bounds, and a support point.
  struct Height {
    double lower = 0, upper = 0;
  };

  void turn_normal();
  void bound_gap();
  void refine_gap(InstructionSet isa);
  Height height_of(const ConvexSet& Q, const Vector& u, double* point) const;
  void put_distance(const ConvexSet& Q, double tolerance, bool points, ObjectDistance& result);
  void put_depth(const ConvexSet& Q, double tolerance, ObjectDepth& depth);
  void put_points(double length, Vector& point_1, Vector& point_2) const;

  const HalfSpace* half_space_ = nullptr;
  std::optional<Posed> body_;
  const Pose* pose_ = nullptr;  // of the half-space; nullptr: the identity
  bool is_first_ = false;       // the half-space
  Vector normal_;               // m, as computed
  double normal_error_ = 0;     // at least |R⁻ᵀn - m|
  Vector direction_, point_;
  Vector magnitude_, minus_;
  Vector of_metric_;  // its support point
  double gap_lower_ = 0, gap_upper_ = 0;
  std::int64_t support_queries_ = 0;

  std::optional<Ball> origin_;
  SpatialPair pair_;  // K and the origin of H
};

}  // namespace raygauge
