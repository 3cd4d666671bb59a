// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/closed_form_distance.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/precise_projection.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

Vector3 nearest_in_box(const SpatialShape& shape, const Vector3& p) {
  const Vector3& half = shape.axis.column[0];
  const Vector3 x = p - shape.center;
  return shape.center + Vector3{std::clamp(x.x, -half.x, half.x), std::clamp(x.y, -half.y, half.y),
                                std::clamp(x.z, -half.z, half.z)};
}

Vector3 nearest_on_segment(const SpatialShape& shape, const Vector3& p) {
  const Vector3& half = shape.axis.column[0];
  const double square = dot(half, half);
  const double share = square > 0 ? std::clamp(dot(p - shape.center, half) / square, -1.0, 1.0) : 0.0;
  return shape.center + half * share;
}

// In the half plane through the axis that holds p, `along` the axis from the base and `across` it.
Vector3 nearest_in_frustum(const SpatialShape& shape, const Vector3& p) {
  const Vector3& axis = shape.axis.column[0];
  const Vector3 x = p - shape.base;
  const double along = dot(x, axis), height = dot(shape.top - shape.base, axis);
  const Vector3 radial = x - axis * along;
  const double across = length(radial);
  const double widening = shape.top_radius - shape.base_radius;
  double z = along, r = across;
  if (along <= 0 && across <= shape.base_radius) {
    z = 0;
  } else if (along >= height && across <= shape.top_radius) {
    z = height;
  } else if (!(along > 0 && along < height &&
               across * height <= shape.base_radius * height + along * widening)) {
    const double share =
        (along * height + (across - shape.base_radius) * widening) / (height * height + widening * widening);
    z = std::clamp(share, 0.0, 1.0) * height;
    r = shape.base_radius + std::clamp(share, 0.0, 1.0) * widening;
  }
  return shape.base + axis * z + (across > 0 ? radial * (r / across) : Vector3{});
}

// p + s x and q + t y, |s|, |t| <= 1, as near to each other as they come: the nearest points of the lines,
// then that of either end of what goes beyond.
void nearest_of_segments(const Vector3& p, const Vector3& x, const Vector3& q, const Vector3& y, double& s,
                         double& t) {
  const Vector3 way = q - p;
  const double xx = dot(x, x), yy = dot(y, y), xy = dot(x, y), xw = dot(x, way), yw = dot(y, way);
  const double area = xx * yy - xy * xy;
  s = area > 0 ? std::clamp((xw * yy - yw * xy) / area, -1.0, 1.0) : 0.0;
  t = yy > 0 ? (s * xy - yw) / yy : 0.0;
  if (std::fabs(t) <= 1) return;
  t = std::clamp(t, -1.0, 1.0);
  s = xx > 0 ? std::clamp((xw + t * xy) / xx, -1.0, 1.0) : 0.0;
}

void nearest_of_capsules(const SpatialPair& pair, SpatialPoint& point) {
  const SpatialShape& one = pair.shape(0);
  const SpatialShape& two = pair.shape(1);
  const Vector3 x = one.axis.column[0], y = pair.rotation() * two.axis.column[0];
  const Vector3 q = pair.from_second(two.center);
  double s = 0, t = 0;
  nearest_of_segments(one.center, x, q, y, s, t);
  point.a1 = one.center + x * s;
  point.a2 = q + y * t;
}

// The ends of a core without area between which x is, in its own frame, the nearer one first, and how much of
// x is that one.
struct Ends {
  int count = 0;  // 0: of other cores
  std::int32_t index[2] = {0, 0};
  double share = 1;
};

Ends ends_around(const SpatialShape& shape, const Vector3& x) {
  constexpr double kAtEnd = 1 - 1e-6;
  if (shape.kind == Kind::point) return {1};
  if (shape.kind != Kind::segment) return {};
  const Vector3& half = shape.axis.column[0];
  const double along = dot(x - shape.center, half), square = dot(half, half);
  const std::int32_t nearer = along < 0 ? 1 : 0;
  if (std::fabs(along) > kAtEnd * square) return {1, {nearer, nearer}};
  return {2, {nearer, 1 - nearer}, square > 0 ? 0.5 + 0.5 * std::fabs(along) / square : 1.0};
}

// Whether a core and a point are the pair: PreciseDescent begins at their nearest points.
bool is_projection(const SpatialPair& pair) {
  const SpatialShape &one = pair.shape(0), &two = pair.shape(1);
  return (has_projection(one) && two.kind == Kind::point) || (has_projection(two) && one.kind == Kind::point);
}

// Vertices around the nearest points of such cores, of which double-double arithmetic makes a start: at most
// three, as the fourth corner of a parallelogram is the farthest. Those three make the point with the weights
// f + g - 1, 1 - g and 1 - f, where f and g are the shares of the nearer ends.
void name_ends(const SpatialPair& pair, const SpatialPoint& nearest, SpatialCombination& combination) {
  if (is_projection(pair)) return;  // the combination is `nearest`
  const Ends one = ends_around(pair.shape(0), nearest.a1),
             two = ends_around(pair.shape(1), pair.to_second(nearest.a2));
  combination.count = 0;
  for (int i = 0; i < one.count; ++i) {
    for (int k = 0; k < two.count; ++k) {
      if (i == 1 && k == 1) continue;
      combination.weight[combination.count] = i == 1   ? 1 - one.share
                                              : k == 1 ? 1 - two.share
                                                       : one.share + two.share - 1;
      pair.core_vertex(one.index[i], two.index[k], combination.point[combination.count++]);
    }
  }
}

bool nearest_points(const SpatialPair& pair, SpatialPoint& point) {
  const Kind one = pair.shape(0).kind, two = pair.shape(1).kind;
  if (two == Kind::point) {
    point.a2 = pair.from_second(pair.shape(1).center);
    return nearest_in_core(pair.shape(0), point.a2, point.a1);
  }
  if (one == Kind::point) {
    Vector3 nearest;
    point.a1 = pair.shape(0).center;
    if (!nearest_in_core(pair.shape(1), pair.to_second(point.a1), nearest)) return false;
    point.a2 = pair.from_second(nearest);
    return true;
  }
  if (one != Kind::segment || two != Kind::segment) return false;
  nearest_of_capsules(pair, point);
  return true;
}

}  // namespace

bool nearest_in_core(const SpatialShape& shape, const Vector3& p, Vector3& nearest) {
  switch (shape.kind) {
    case Kind::point:
      nearest = shape.center;
      return true;
    case Kind::segment:
      nearest = nearest_on_segment(shape, p);
      return true;
    case Kind::box:
      nearest = nearest_in_box(shape, p);
      return true;
    case Kind::frustum:
      nearest = nearest_in_frustum(shape, p);
      return true;
    default:
      return false;
  }
}

bool closed_form_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer) {
  SpatialPoint nearest;
  if (!nearest_points(pair, nearest)) return false;
  nearest.s = nearest.a1 - nearest.a2;
  const double size = length(nearest.s);
  if (!(size > pair.error())) return false;
  answer.iterations = 1;
  answer.combination.count = 1;
  answer.combination.point[0] = nearest;
  answer.combination.weight[0] = 1;
  answer.bound_from_above(upper_bound(pair, size));
  if (answer.upper < 0) {
    answer.end = SpatialEnd::intersecting;
    return true;
  }
  answer.hint = nearest.s * (-1 / size);
  SpatialPoint touched;
  pair.support(answer.hint, touched);
  answer.bound_from_below(lower_bound(pair, dot(answer.hint, touched.s)), answer.hint);
  if (answer.closes(tolerance)) return true;
  name_ends(pair, nearest, answer.combination);
  return false;
}

}  // namespace raygauge
