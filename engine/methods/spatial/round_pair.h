// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/methods/spatial/pair_frames.h"

namespace raygauge {

/// The signed Euclidean distance of two bodies of R^3 for which that is a formula: of balls and capsules, and
/// of a ball and a box, a cylinder, a (truncated) cone or an ellipsoid. With the nearest points a1, a2 of the
/// cores it is |a1 - a2| less both radii; of a point inside the other core, the least way out, negative, less
/// the radius.
///
/// Nothing is made of the sets beforehand, and nothing is kept. Everything is taken about the origin of the
/// first body's frame along the axes of the world. The bounds are proven by what was found: points, and the
/// support function along the normal; where a centre is inside, by a ball around it inside the core. Rounding
/// errors are covered as in SpatialPair. All is in line: the formulas take less time than calls.
struct RoundPair {
  enum class Formula : std::uint8_t {
    none,
    points,
    point_and_segment,
    segment_and_point,
    segments,
    point_and_box,
    box_and_point,
    point_and_frustum,
    frustum_and_point,
    point_and_ellipsoid,
    ellipsoid_and_point,
  };
  static constexpr int kFormulas = 11;

  /// Which formula two bodies of R^3 have.
  static Formula formula(const SpatialShape& first, const SpatialShape& second) noexcept;

  /// What use.operator()<formula>() returns; false where there is none.
  template <class Use>
  [[gnu::always_inline]] static inline bool with(Formula formula, const Use& use);

  /// Bodies that have this formula, where they stand.
  template <Formula kFormula>
  [[gnu::always_inline]] inline void solve(const SpatialShape& first, const SpatialShape& second,
                                           const PoseNumbers& pose_1, const PoseNumbers& pose_2) noexcept;

  /// Whether a signed distance of this value has a gradient for certain: one normal and one pair of points.
  /// has_one_way() says so first where that is plain.
  static bool is_differentiable(double value, const SpatialShape& first, const SpatialShape& second,
                                const PoseNumbers& pose_1, const PoseNumbers& pose_2) noexcept;

  /// Of a ball whose centre is outside of the other core, or of two cores on which there is one way only.
  template <Formula kFormula>
  [[gnu::always_inline]] static inline bool has_one_way(double value, const SpatialShape& first,
                                                        const SpatialShape& second, const PoseNumbers& pose_1,
                                                        const PoseNumbers& pose_2) noexcept;

  double lower = 0, upper = 0;  ///< of the signed distance
  Vector3 normal;               ///< from the second body to the first: what proves `lower`, of length 1
  Vector3 point_1, point_2;  ///< of the surfaces, in the world: their difference is the signed distance times
                             ///< the normal
  bool is_known = false;     ///< false where sizes are out of the range of squares, or rounding hides a
                             ///< direction: then the rest says nothing
};

}  // namespace raygauge

#include "engine/methods/spatial/round_pair_formulas.h"
