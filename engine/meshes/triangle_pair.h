// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/meshes/box_tree.h"

namespace raygauge {

/// What doubles find of the distance of two triangles in one frame. Both bounds are off by rounding errors of
/// a few units of the coordinates' size; the caller adds its own margin.
struct TriangleDistance {
  double lower = 0;
  double upper = 0;
  Vector3 point_1, point_2;  ///< whose distance is `upper`
  Vector3 normal;            ///< a unit vector from 1 to 2 that proves `lower`; zero: none does
};

/// The algorithm of Gilbert, Johnson & Keerthi on two triangles, from the direction `from` (not zero) on,
/// until the bounds are within `tolerance` of each other, relative, or `lower` is at least `enough`: then
/// `upper` is that of any two points. Triangles that meet, or nearly, end with lower = 0.
TriangleDistance triangle_distance(const TriangleCorners& one, const TriangleCorners& two, Vector3 from,
                                   double tolerance, double enough);

}  // namespace raygauge
