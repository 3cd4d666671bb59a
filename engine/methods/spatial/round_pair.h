// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/pair_frames.h"

namespace raygauge {

/// The signed Euclidean distance of two bodies of R^3 for which that is a formula: of balls and capsules, and
/// of a ball and a box, a cylinder or a (truncated) cone. With the nearest points a1, a2 of the cores it is
/// |a1 - a2| less both radii; of a point inside the other core, the least way out, negative, less the radius.
///
/// Nothing is made of the sets beforehand, and nothing is kept. Everything is taken about the origin of the
/// first body's frame along the axes of the world. The bounds are proven by what was found: points, and the
/// support function along the normal; where a centre is inside, by a ball around it inside the core. Rounding
/// errors are covered as in SpatialPair.
class RoundPair {
 public:
  static bool has_formula(const SpatialShape& first, const SpatialShape& second) noexcept;

  /// Of bodies that have a formula. False, and nothing is said, where sizes are out of the range of squares,
  /// or rounding hides a direction.
  bool solve(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
             const PoseNumbers& pose_2) noexcept;

  /// Whether the signed distance that was found for these has a gradient for certain: one normal and one pair
  /// of points.
  bool is_differentiable(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                         const PoseNumbers& pose_2) const noexcept;

  /// Of the signed distance.
  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }

  /// From the second body to the first: what proves lower(), of length 1.
  const Vector3& normal() const noexcept { return normal_; }

  /// Of the surfaces, in the world: a1 - a2 is the signed distance times the normal.
  const Vector3& point_1() const noexcept { return point_1_; }
  const Vector3& point_2() const noexcept { return point_2_; }

 private:
  template <class Find>
  bool solve_by(const Find& find, const SpatialShape& first, const SpatialShape& second,
                const PoseNumbers& pose_1, const PoseNumbers& pose_2) noexcept;
  bool solve_points(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                    const PoseNumbers& pose_2) noexcept;
  bool solve_segments(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                      const PoseNumbers& pose_2) noexcept;
  template <class Core, int kAt>
  bool solve_core(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                  const PoseNumbers& pose_2) noexcept;

  double lower_ = 0, upper_ = 0;
  Vector3 normal_, point_1_, point_2_;
};

}  // namespace raygauge
