// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// p + s x and q + t y, |s|, |t| <= 1, as near to each other as they come: the nearest points of the lines,
/// then that of either end of what goes beyond. x or y may be 0.
inline void nearest_of_segments(const Vector3& p, const Vector3& x, const Vector3& q, const Vector3& y,
                                double& s, double& t) {
  constexpr double kLeast = 1e-300;  // of a square; a shorter segment is a point
  const Vector3 way = q - p;
  const double xx = dot(x, x), yy = dot(y, y), xy = dot(x, y), xw = dot(x, way), yw = dot(y, way);
  const double area = xx * yy - xy * xy;
  const double inverse = yy > kLeast ? 1 / yy : 0.0;  // while the other quotient is computed
  s = area > 0 ? std::clamp((xw * yy - yw * xy) / area, -1.0, 1.0) : 0.0;
  t = (s * xy - yw) * inverse;
  if (yy > kLeast && std::fabs(t) <= 1) return;
  t = std::clamp(t, -1.0, 1.0);
  s = xx > 0 ? std::clamp((xw + t * xy) / xx, -1.0, 1.0) : 0.0;
}

}  // namespace raygauge
