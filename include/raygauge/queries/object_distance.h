// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/numerics/vector3.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

class Ladder;

/// What to compute of two objects besides their distance. What is not asked for costs nothing.
enum class ObjectEffects : std::uint8_t {
  none = 0,
  closest_points = 1,  ///< of (18)
  gradient = 2,        ///< of the distance, or of minus the depth, when either object moves
  depth = 4,           ///< of objects that meet: see ObjectDepth; the distance is then a signed one
  pose_gradient = 8,   ///< of the same with respect to twists, in R^2 and R^3; with the closest points
};

constexpr ObjectEffects operator|(ObjectEffects a, ObjectEffects b) noexcept {
  return static_cast<ObjectEffects>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

constexpr bool has_effect(ObjectEffects asked, ObjectEffects effect) noexcept {
  return (static_cast<unsigned>(asked) & static_cast<unsigned>(effect)) != 0;
}

/// How deep two objects A1, A2 that meet are in each other: with D = A2 - A1,
///
///     depth_Q = max{t >= 0 : tQ ⊆ D} = min{h_D(u)/h_Q(u) : u != 0},
///
/// the least translation of A1, measured by Q, after which the interiors are disjoint. Values that were not
/// computed are NaN or empty.
struct ObjectDepth {
  double depth = DistanceResult::kUnset;  ///< `upper`; 0 if the interiors are disjoint
  double lower = DistanceResult::kUnset;  ///< certified if above 0: lower Q ⊆ D, for all directions at once
  double upper = DistanceResult::kUnset;  ///< certified: h_D(normal)

  /// `optimal`: upper - lower <= tolerance * upper, or both are 0. `unreachable`: the depth is infinite. A
  /// limit otherwise; the bounds hold.
  DistanceStatus status = DistanceStatus::precision_limit;

  /// u, with h_Q(u) = 1, the way for A1 to get out; for A2 it is the other way.
  Vector normal;
  Vector point_1;  ///< a1 in A1, and ...
  Vector point_2;  ///< ... a2 in A2, the points in contact: a2 - a1 is in D, on its face across u or nearly
  std::int64_t evaluations = 0;      ///< depths computed: 0 or 1
  std::int64_t iterations = 0;       ///< facets expanded for the depth
  std::int64_t support_queries = 0;  ///< support queries for the depth
};

/// The distance of two objects. Vectors that were not requested, or that do not exist (the objects meet, or
/// the distance is infinite), are empty.
struct ObjectDistance {
  DistanceResult
      distance;  ///< d_Q(A2 - A1) with its bounds; 0 with status contains_origin if the objects meet
  Vector closest_point_1;      ///< in A1 ...
  Vector closest_point_2;      ///< ... and in A2: their difference has the gauge `distance`, to the gap
  Vector gradient_1;           ///< of signed_distance(), with respect to a translation of A1: the normal u
  Vector gradient_2;           ///< ... of A2: -u
  PoseGradient pose_gradient;  ///< of signed_distance(), with respect to the twists of both
  ObjectDepth depth;  ///< only with ObjectEffects::depth, and if the objects are not proven to be apart
  std::int64_t closest_point_evaluations = 0;  ///< pairs of closest points computed: 0 or 1
  std::int64_t gradient_evaluations = 0;       ///< pairs of gradients computed: 0 or 1
  std::int64_t pose_gradient_evaluations = 0;  ///< gradients by pose computed: 0 or 1

  /// The signed distance: the distance, or minus the depth where that was computed.
  double signed_distance() const noexcept { return depth.evaluations > 0 ? -depth.depth : distance.distance; }
};

/// Computes the distance from object A1 to object A2 in the metric of Q, section III-C of Zheng & Yamane,
///
///     d_Q(A2 - A1) = min{gauge_Q(a2 - a1) : a1 in A1, a2 in A2},
///
/// and the closest points (18): with the support points s_l = s_A2(u_l) - s_A1(-u_l) and the weights c_l of
/// the combination that proves the upper bound,  a1 = Σ c_l s_A1(-u_l),  a2 = Σ c_l s_A2(u_l).
///
/// The distance is that of the p-norm for Q = PNormBall(0, 1, p). One solver per thread; a repeated solve of
/// the same size allocates nothing.
class ObjectDistanceSolver {
 public:
  /// Throws InvalidParameterError for an option outside its range.
  explicit ObjectDistanceSolver(const DistanceOptions& options = {});
  ~ObjectDistanceSolver();
  ObjectDistanceSolver(ObjectDistanceSolver&&) noexcept;
  ObjectDistanceSolver& operator=(ObjectDistanceSolver&&) noexcept;

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// The result belongs to the solver and lives until its next solve. Throws DimensionMismatchError.
  const ObjectDistance& solve(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q,
                              ObjectEffects effects = ObjectEffects::none);

  /// The same for objects in poses: solve({A1, pose_1}, {A2, pose_2}, Q). `warm` is the state that
  /// the last solve of this pair stored; this solve updates it. nullptr: a cold start.
  const ObjectDistance& solve(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                              ObjectEffects effects = ObjectEffects::none, WarmStart* warm = nullptr);

 private:
  std::unique_ptr<Ladder> ladder_;
};

/// Computes how deep the origin is in a set D, measured by Q,
///
///     depth_Q(D) = max{t >= 0 : tQ ⊆ D} = min{h_D(u)/h_Q(u) : u != 0},
///
/// of any sets of R^1 to R^6, by their support mappings alone: see ObjectDepth, with A1 = {0} and A2 = D.
/// With the wrenches that a grasp can exert for D it is the grasp quality of Ferrari & Canny ("Planning
/// optimal grasps", 1992), see GraspWrenches. It is 0 if the origin is outside of D or on its boundary. In
/// larger spaces there are bounds only, 0 and the least of 2n directions.
///
/// The method is that of expanding polytopes; 4 to 6 dimensions take up to 200 MB for hard curved sets, and
/// end with `iteration_limit` there. One solver per thread; a repeated solve of the same size allocates
/// nothing.
class DepthSolver {
 public:
  /// Tolerance and limits. Throws InvalidParameterError for an option outside its range.
  explicit DepthSolver(const DistanceOptions& options = {});
  ~DepthSolver();
  DepthSolver(DepthSolver&&) noexcept;
  DepthSolver& operator=(DepthSolver&&) noexcept;

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// The result belongs to the solver and lives until its next solve. With `normal` u and q the support point
  /// of Q for it, `point_2` is the point of D where the ray along q leaves it: depth q, to the gap. Throws
  /// DimensionMismatchError.
  const ObjectDepth& solve(const ConvexSet& D, const ConvexSet& Q);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// A point of either body, one above the other along the normal. In the world, z = 0 in R^2.
struct ContactPoint {
  Vector3 point_1, point_2;
  double gap = 0;  ///< normal·(point_2 - point_1): below 0 where the bodies overlap
};

/// Where two bodies of R^2 or R^3 are in contact, within a margin: at most 8 pairs of points that span what
/// their faces across the common normal have in common. Corners of faces count, with the faces' own slopes:
/// box on box gives up to 8 corners of a polygon, an edge on a face 2, a vertex 1. Curved bodies have discs,
/// whose polygon of 8 corners lacks at most 0.076 of the radius, lines along cylinders, cones and capsules,
/// or points.
///
/// While the same faces and edges are within the margin, points move continuously with the bodies. Corners of
/// the disc are fixed to its body. Where corners miss the nearest or deepest pair by more than a hundredth of
/// the margin, this pair is added as the last one; the others go around the patch in order.
struct ContactPatch {
  static constexpr int kMost = 8;

  int count = 0;  ///< 0: the bodies are farther apart than the margin, or nothing is known (see status)
  std::array<ContactPoint, kMost> points{};  ///< those from `count` on are old

  /// Of length 1, from the first body to the second: along what the distance or the depth is measured.
  Vector3 normal;

  /// Every point is at most this far from its body, and from the surface of it: proven, rounding included.
  double error = DistanceResult::kUnset;

  /// Bounds on the signed distance, to the tolerance or 1e-9 of the margin, and its status: ObjectDistance.
  double lower = DistanceResult::kUnset, upper = DistanceResult::kUnset;
  DistanceStatus status = DistanceStatus::precision_limit;

  std::span<const ContactPoint> contacts() const noexcept {
    return {points.data(), static_cast<std::size_t>(count)};
  }
};

/// Computes contact patches. One solver per thread; a repeated solve allocates nothing.
class ContactPatchSolver {
 public:
  /// Tolerance and limits of the distance and the depth. Throws InvalidParameterError for an option outside
  /// its range.
  explicit ContactPatchSolver(const DistanceOptions& options = patch_options());
  ~ContactPatchSolver();
  ContactPatchSolver(ContactPatchSolver&&) noexcept;
  ContactPatchSolver& operator=(ContactPatchSolver&&) noexcept;

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// The patch of all pairs of points with a gap of at most `margin` >= 0. `warm`: as in
  /// ObjectDistanceSolver. The result belongs to the solver and lives until its next solve. Throws
  /// DimensionMismatchError, or InvalidParameterError for a negative margin and spaces other than R^2 and
  /// R^3.
  const ContactPatch& solve(const Posed& A1, const Posed& A2, double margin, WarmStart* warm = nullptr);

 private:
  static DistanceOptions patch_options();

  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace raygauge
