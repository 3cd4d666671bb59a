// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_projection.h"

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

DoubleDouble clamped(const DoubleDouble& y, double one, double other) {
  const double low = one < other ? one : other, high = one < other ? other : one;
  if (y < DoubleDouble{low}) return DoubleDouble{low};
  return y > DoubleDouble{high} ? DoubleDouble{high} : y;
}

// In the half plane through the axis that holds y: `share` of the way from the base to the top.
PreciseVector3 nearest_in_frustum(const SpatialShape& shape, const PreciseVector3& y) {
  const DoubleDouble none{0}, all{1};
  const PreciseVector3 base = precise(shape.base), axis = precise(shape.top) - base, x = y - base;
  const DoubleDouble square = dot(axis, axis);
  const DoubleDouble share = dot(x, axis) / square;
  const PreciseVector3 radial = x - axis * share;
  const DoubleDouble across = sqrt(dot(radial, radial));
  const DoubleDouble widening = two_sum(shape.top_radius, -shape.base_radius);
  const bool below = !(share > none), above = !(share < all);
  if (below && !(across > DoubleDouble{shape.base_radius})) return base + radial;
  if (above && !(across > DoubleDouble{shape.top_radius})) return base + axis + radial;
  if (!below && !above && !(across > widening * share + shape.base_radius)) return y;
  DoubleDouble way = share;  // of a cylinder
  if (widening.high != 0) {
    way = (share * square + (across - DoubleDouble{shape.base_radius}) * widening) /
          (square + widening * widening);
  }
  if (way < none) way = none;
  if (way > all) way = all;
  const DoubleDouble radius = widening * way + shape.base_radius;
  return base + axis * way + radial * (radius / across);
}

}  // namespace

bool has_projection(const SpatialShape& shape) {
  return shape.kind == Kind::box || shape.kind == Kind::frustum;
}

RAYGAUGE_FUSED PreciseVector3 nearest_in_core(const SpatialShape& shape, const PreciseVector3& y) {
  if (shape.kind == Kind::frustum) return nearest_in_frustum(shape, y);
  return {clamped(y.x, shape.base.x, shape.top.x), clamped(y.y, shape.base.y, shape.top.y),
          clamped(y.z, shape.base.z, shape.top.z)};
}

}  // namespace raygauge
