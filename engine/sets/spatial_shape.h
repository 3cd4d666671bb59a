// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "raygauge/numerics/vector3.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

class DirectionTable;

/// What fixed-size code needs of a set in R^2 or R^3: a core whose support function is evaluated in line, and
/// the radius of a ball that is added to it. Made when the set is.
struct SpatialShape {
  enum class Kind : std::uint8_t {
    point,      ///< the centre
    segment,    ///< centre ± axis.column[0]
    box,        ///< centre ± half edges, axis.column[0] = (half edges)
    ellipsoid,  ///< centre + axis z, |z| <= 1
    frustum,    ///< hull of two discs across the unit vector axis.column[0]
    points,     ///< the hull of points in PointSet's layout
  };

  Kind kind = Kind::point;
  bool is_centered = false;       ///< the centre is known to be the origin
  bool has_right_angles = false;  ///< of an ellipsoid: the columns of `axis`, but for rounding; not too flat
  Vector3 center;                 ///< ConvexSet::center
  double radius = 0;              ///< of the ball added
  double extent = 0;        ///< at least |x| for every point of the core, and for what they are computed from
  double inner_radius = 0;  ///< of a ball about the centre inside the set, proven; 0 where none is known
  double rolling_radius =
      0;  ///< of a ball that rolls inside the core of R^3: that is its sum with another set
  Matrix3 axis;
  Vector3 base,
      top;  ///< centres of the discs; ends of the segment, corners of the box, both without rounding
  double base_radius = 0, top_radius = 0;
  double full = 0, side_along = 0, side_across = 0;  ///< of a frustum: from base to top, normal of its side
  const double* blocks = nullptr;                    ///< PointSet::data() ...
  int coordinates = 3;                               ///< ... and its dimension
  std::ptrdiff_t block_count = 0;
  std::ptrdiff_t size = 0;
  const DirectionTable* table = nullptr;  ///< of a prepared set
};

/// Of a ball of R^2 or R^3 about the origin; 0 of every other set.
inline double radius_of_ball(const ConvexSet& Q) noexcept {
  const SpatialShape* shape = Q.spatial_shape();
  if (shape == nullptr || shape->kind != SpatialShape::Kind::point) return 0;
  return shape->is_centered ? shape->radius : 0.0;
}

}  // namespace raygauge
