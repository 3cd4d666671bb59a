// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/methods/warm_start.h"
#include "raygauge/numerics/vector3.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

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

  /// Bounds on the signed distance of the bodies, and its status: see ObjectDistance and ObjectDepth.
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
