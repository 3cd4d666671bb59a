// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/closed_form_distance.h"

#include <cmath>

#include "engine/methods/spatial/nearest_of_segments.h"

namespace raygauge {
namespace {

void nearest_of_capsules(const SpatialPair& pair, SpatialPoint& point) {
  const SpatialShape& one = pair.shape(0);
  const SpatialShape& two = pair.shape(1);
  const Vector3 x = one.axis.column[0], y = pair.frame().R * two.axis.column[0];
  const Vector3 q = pair.frame().from_second(two.center);
  double s = 0, t = 0;
  nearest_of_segments(one.center, x, q, y, s, t);
  point.a1 = one.center + x * s;
  point.a2 = q + y * t;
}

CoreEnds ends_around(const SpatialShape& shape, const Vector3& x) {
  return with_core(shape, [&x](const auto& core) {
    if constexpr (requires { core.ends_around(x); }) return core.ends_around(x);
    return CoreEnds{};
  });
}

// Whether a core and a point are the pair: PreciseDescent begins at their nearest points.
bool is_projection(const SpatialPair& pair) {
  const SpatialShape &one = pair.shape(0), &two = pair.shape(1);
  return (has_projection(one) && is_point(two)) || (has_projection(two) && is_point(one));
}

// Vertices around the nearest points of such cores, of which double-double arithmetic makes a start: at most
// three, as the fourth corner of a parallelogram is the farthest. Those three make the point with the weights
// f + g - 1, 1 - g and 1 - f, where f and g are the shares of the nearer ends.
void name_ends(const SpatialPair& pair, const SpatialPoint& nearest, SpatialCombination& combination) {
  if (is_projection(pair)) return;  // the combination is `nearest`
  const CoreEnds one = ends_around(pair.shape(0), nearest.a1),
                 two = ends_around(pair.shape(1), pair.frame().to_second(nearest.a2));
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

// False where the core has no formula.
bool find_nearest(const SpatialShape& shape, const Vector3& p, Vector3& nearest) {
  return with_core(shape, [&](const auto& core) {
    if constexpr (requires { core.nearest(p); }) {
      nearest = core.nearest(p);
      return true;
    }
    return false;
  });
}

bool nearest_points(const SpatialPair& pair, SpatialPoint& point) {
  const SpatialShape &one = pair.shape(0), &two = pair.shape(1);
  if (is_point(two)) {
    point.a2 = pair.frame().from_second(two.center);
    return find_nearest(one, point.a2, point.a1);
  }
  if (is_point(one)) {
    Vector3 nearest;
    point.a1 = one.center;
    if (!find_nearest(two, pair.frame().to_second(point.a1), nearest)) return false;
    point.a2 = pair.frame().from_second(nearest);
    return true;
  }
  if (!is_between_ends(one) || !is_between_ends(two)) return false;
  nearest_of_capsules(pair, point);
  return true;
}

}  // namespace

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
  answer.bounds.reduce_upper(upper_bound(pair, size));
  if (answer.bounds.upper() < 0) {
    answer.end = SpatialEnd::intersecting;
    return true;
  }
  answer.hint = nearest.s * (-1 / size);
  SpatialPoint touched;
  pair.support(answer.hint, touched);
  answer.raise_lower(lower_bound(pair, dot(answer.hint, touched.s)), answer.hint);
  if (answer.closes(tolerance)) return true;
  name_ends(pair, nearest, answer.combination);
  return false;
}

}  // namespace raygauge
