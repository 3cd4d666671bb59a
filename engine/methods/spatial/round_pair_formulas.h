// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/ellipsoid_way.h"
#include "engine/methods/spatial/nearest_of_segments.h"
#include "engine/methods/spatial/round_pair.h"

namespace raygauge {
namespace round_pair {

using Kind = SpatialShape::Kind;

// As of SpatialPair, whose chain of operations is longer; a quarter more for the sums of the bounds.
inline constexpr double kRounding = 320 * 0x1p-53;
inline constexpr double kParallel = 1e-6;  // the sine of an angle
inline constexpr double kLonger = 1e-9;    // of the size: a way that much longer is another one
inline constexpr double kSmallest = 1e-70, kLargest = 1e70;

inline constexpr double kIdentity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

// Where a body is, from the origin of the first one's frame: x -> R x + t, R by columns.
struct Place {
  const double* R = nullptr;
  Vector3 t;

  Vector3 turn(const Vector3& x) const noexcept {
    return {R[0] * x.x + R[3] * x.y + R[6] * x.z, R[1] * x.x + R[4] * x.y + R[7] * x.z,
            R[2] * x.x + R[5] * x.y + R[8] * x.z};
  }
  Vector3 turn_back(const Vector3& u) const noexcept {
    return {R[0] * u.x + R[1] * u.y + R[2] * u.z, R[3] * u.x + R[4] * u.y + R[5] * u.z,
            R[6] * u.x + R[7] * u.y + R[8] * u.z};
  }
  Vector3 center_of(const SpatialShape& shape) const noexcept {
    return shape.is_centered ? t : turn(shape.center) + t;
  }
};

// Of the cores: bounds on the signed distance, without rounding, and what proves them.
struct Found {
  double lower = 0, upper = -1;
  Vector3 normal, point_1, point_2;
  bool is_known = false;
};

// Of two points: all but the lower bound, which is the upper one where the normal is that of both cores.
[[gnu::always_inline]] inline Found between(const Vector3& p, const Vector3& q, double error) {
  const Vector3 way = p - q;
  const double square = dot(way, way), away = std::sqrt(square);
  return {away, away, way * (away * (1 / square)), p, q, away > error};
}

// The first core is the point p, the second one q ± y.
[[gnu::always_inline]] inline Found between(const Vector3& p, const Vector3& q, const Vector3& y,
                                            double error) {
  const Vector3 way = p - q;
  const double square = dot(y, y), share = square > 0 ? dot(way, y) / square : 0;
  Found found = between(p, q + y * std::clamp(share, -1.0, 1.0), error);
  found.lower = dot(found.normal, way) - std::fabs(dot(found.normal, y));
  return found;
}

[[gnu::always_inline]] inline Found between(const Vector3& p, const Vector3& x, const Vector3& q,
                                            const Vector3& y, double error) {
  double s = 0, t = 0;
  nearest_of_segments(p, x, q, y, s, t);
  Found found = between(p + x * s, q + y * t, error);
  found.lower = dot(found.normal, p - q) - std::fabs(dot(found.normal, x)) - std::fabs(dot(found.normal, y));
  return found;
}

[[gnu::always_inline]] inline Found turned(const Found& found) {
  return {found.lower, found.upper, -found.normal, found.point_2, found.point_1, found.is_known};
}

// Of a core and a point y in its frame: the signed distance from below, by the support function of the core
// along the normal, and from above, by the way to its surface.
struct FromCore {
  double lower = 0, upper = 0;
  Vector3 outward;
  bool is_known = true;
};

[[gnu::always_inline]] inline FromCore way_from(const BoxCore& core, const Vector3& y, double error) {
  const Vector3 way = y - core.nearest(y);
  const double square = dot(way, way);
  if (square > 0) {
    const double away = std::sqrt(square);
    return {away, away, way * (away * (1 / square)), away > error};
  }
  Vector3 outward;
  const double room = core.way_out(y, outward);
  return {-room, -room, outward};
}

// In the half-plane through the axis that holds a point: (z, r) along the axis from the base and away from
// it. There a cylinder or a cone is a quadrangle with the corners (0, 0), (0, base radius), (full, top
// radius), (full, 0).
[[gnu::always_inline]] inline double height_of(const SpatialShape& frustum, double n_z, double n_r) {
  return std::max(n_r * frustum.base_radius, n_z * frustum.full + n_r * frustum.top_radius);
}

// Of the way to the surface its length, negative inside, and the normal.
[[gnu::always_inline]] inline double way_from(const SpatialShape& frustum, double z, double r, double& n_z,
                                              double& n_r) {
  const double from_top = z - frustum.full, from_base = r - frustum.base_radius;
  const double beside = from_base * frustum.side_across + z * frustum.side_along;
  const double foot = z * frustum.side_across - from_base * frustum.side_along;  // on the side
  const auto has_foot = [&] {
    const double widening = frustum.top_radius - frustum.base_radius;
    return foot >= 0 && foot <= frustum.full * frustum.side_across - widening * frustum.side_along;
  };
  n_z = frustum.side_along;
  n_r = frustum.side_across;
  if (beside <= 0 && z > 0 && from_top < 0) {
    const double along = std::max(-z, from_top);
    if (along < beside) return beside;
    n_z = -z > from_top ? -1.0 : 1.0;
    n_r = 0;
    return along;
  }
  if (z <= 0 && r <= frustum.base_radius) {
    n_z = -1;
    n_r = 0;
    return -z;
  }
  if (from_top >= 0 && r <= frustum.top_radius) {
    n_z = 1;
    n_r = 0;
    return from_top;
  }
  if (has_foot()) return beside;
  const double way_z = foot < 0 ? z : from_top, way_r = foot < 0 ? from_base : r - frustum.top_radius;
  const double square = way_z * way_z + way_r * way_r, length = std::sqrt(square);
  n_z = way_z * (length * (1 / square));
  n_r = way_r * (length * (1 / square));
  return length;
}

// In the axes of the world, from the middle of the axis: that is where the body is, mostly.
[[gnu::always_inline]] inline Found from_core(const Vector3& center, const FrustumCore& core,
                                              const Place& own, double error) {
  constexpr double kCancelled = 0.01;  // r²/|x|² below which the way from the axis is turned across it again
  constexpr double kAtAxis = 1e-20;    // ... and below which any way across the axis does
  const SpatialShape& shape = core.shape;
  const Vector3 a = own.turn(shape.axis.column[0]), x = center - own.center_of(shape);
  const double from_middle = dot(x, a), z = from_middle + 0.5 * shape.full;
  Vector3 radial = x - a * from_middle;
  double square = dot(radial, radial), r = std::sqrt(square), share = r * (1 / square);
  if (!(square > kCancelled * dot(x, x))) {
    radial = radial - a * dot(radial, a);
    r = length(radial);
    if (!(r * r > kAtAxis * dot(x, x))) radial = any_orthogonal(a);
    share = 1 / length(radial);
  }
  double n_z = 0, n_r = 0;
  const double upper = way_from(shape, z, r, n_z, n_r);
  const bool is_known = !(std::fabs(upper) <= error);  // else rounding hides the way to a rim
  const Vector3 outward = a * n_z + radial * (n_r * share);
  const double lower = n_z * z + n_r * r - height_of(shape, n_z, n_r);
  return {lower, upper, outward, center, center - outward * upper, is_known};
}

[[gnu::always_inline]] inline FromCore way_from(const EllipsoidCore& core, const Vector3& y,
                                                double /*error*/) {
  const Vector3 x = y - core.shape.center;
  const EllipsoidWay way(core.shape.axis, x);
  return {way.lower(), way.upper(core.shape.axis, x), way.outward * way.scale};
}

// The first core is a point, the second one is `core`, where it stands.
template <class Core>
[[gnu::always_inline]] inline Found from_core(const Vector3& center, const Core& core, const Place& own,
                                              double error) {
  const FromCore way = way_from(core, own.turn_back(center - own.t), error);
  const Vector3 outward = own.turn(way.outward);
  return {way.lower, way.upper, outward, center, center - outward * way.upper, way.is_known};
}

template <RoundPair::Formula kFormula>
[[gnu::always_inline]] inline Found find(const SpatialShape& first, const SpatialShape& second,
                                         const Place& one, const Place& two, double error) {
  using F = RoundPair::Formula;
  if constexpr (kFormula == F::points) return between(one.center_of(first), two.center_of(second), error);
  if constexpr (kFormula == F::point_and_segment)
    return between(one.center_of(first), two.center_of(second), two.turn(second.axis.column[0]), error);
  if constexpr (kFormula == F::segment_and_point)
    return turned(find<F::point_and_segment>(second, first, two, one, error));
  if constexpr (kFormula == F::segments)
    return between(one.center_of(first), one.turn(first.axis.column[0]), two.center_of(second),
                   two.turn(second.axis.column[0]), error);
  if constexpr (kFormula == F::point_and_box)
    return from_core(one.center_of(first), BoxCore{second}, two, error);
  if constexpr (kFormula == F::box_and_point)
    return turned(find<F::point_and_box>(second, first, two, one, error));
  if constexpr (kFormula == F::point_and_frustum)
    return from_core(one.center_of(first), FrustumCore{second}, two, error);
  if constexpr (kFormula == F::frustum_and_point)
    return turned(find<F::point_and_frustum>(second, first, two, one, error));
  if constexpr (kFormula == F::point_and_ellipsoid)
    return from_core(one.center_of(first), EllipsoidCore{second}, two, error);
  if constexpr (kFormula == F::ellipsoid_and_point)
    return turned(find<F::point_and_ellipsoid>(second, first, two, one, error));
}

}  // namespace round_pair

inline RoundPair::Formula RoundPair::formula(const SpatialShape& first, const SpatialShape& second) noexcept {
  using F = Formula;
  constexpr F kNone = F::none;
  static constexpr F kOfKinds[6][6] = {{F::points, F::point_and_segment, F::point_and_box,
                                        F::point_and_ellipsoid, F::point_and_frustum, kNone},
                                       {F::segment_and_point, F::segments, kNone, kNone, kNone, kNone},
                                       {F::box_and_point, kNone, kNone, kNone, kNone, kNone},
                                       {F::ellipsoid_and_point, kNone, kNone, kNone, kNone, kNone},
                                       {F::frustum_and_point, kNone, kNone, kNone, kNone, kNone},
                                       {kNone, kNone, kNone, kNone, kNone, kNone}};
  const F formula = kOfKinds[static_cast<int>(first.kind)][static_cast<int>(second.kind)];
  if (formula != F::point_and_ellipsoid && formula != F::ellipsoid_and_point) return formula;
  const SpatialShape& ellipsoid = formula == F::point_and_ellipsoid ? second : first;
  return ellipsoid.has_right_angles ? formula : kNone;
}

template <class Use>
[[gnu::always_inline]] inline bool RoundPair::with(Formula formula, const Use& use) {
  switch (formula) {
    case Formula::none:
      return false;
    case Formula::points:
      return use.template operator()<Formula::points>();
    case Formula::point_and_segment:
      return use.template operator()<Formula::point_and_segment>();
    case Formula::segment_and_point:
      return use.template operator()<Formula::segment_and_point>();
    case Formula::segments:
      return use.template operator()<Formula::segments>();
    case Formula::point_and_box:
      return use.template operator()<Formula::point_and_box>();
    case Formula::box_and_point:
      return use.template operator()<Formula::box_and_point>();
    case Formula::point_and_frustum:
      return use.template operator()<Formula::point_and_frustum>();
    case Formula::frustum_and_point:
      return use.template operator()<Formula::frustum_and_point>();
    case Formula::point_and_ellipsoid:
      return use.template operator()<Formula::point_and_ellipsoid>();
    case Formula::ellipsoid_and_point:
      return use.template operator()<Formula::ellipsoid_and_point>();
  }
  return false;
}

template <RoundPair::Formula kFormula>
[[gnu::always_inline]] inline bool RoundPair::has_one_way(double value, const SpatialShape& first,
                                                          const SpatialShape& second,
                                                          const PoseNumbers& pose_1,
                                                          const PoseNumbers& pose_2) noexcept {
  using namespace round_pair;
  using F = Formula;
  if constexpr (kFormula == F::points || kFormula == F::point_and_segment || kFormula == F::segment_and_point)
    return true;
  if constexpr (kFormula == F::segments) {
    const Vector3 x = Place{pose_1.R != nullptr ? pose_1.R : kIdentity, {}}.turn(first.axis.column[0]),
                  y = Place{pose_2.R != nullptr ? pose_2.R : kIdentity, {}}.turn(second.axis.column[0]);
    const Vector3 across = cross(x, y);
    return dot(across, across) > kParallel * kParallel * dot(x, x) * dot(y, y);
  }
  constexpr bool kAtSecond =
      kFormula == F::point_and_box || kFormula == F::point_and_frustum || kFormula == F::point_and_ellipsoid;
  const double size = kAtSecond ? second.extent : first.extent;
  return value + first.radius + second.radius > kLonger * size;
}

template <RoundPair::Formula kFormula>
[[gnu::always_inline]] inline void RoundPair::solve(const SpatialShape& first, const SpatialShape& second,
                                                    const PoseNumbers& pose_1,
                                                    const PoseNumbers& pose_2) noexcept {
  using namespace round_pair;
  const auto vector = [](const double* t) { return t != nullptr ? Vector3{t[0], t[1], t[2]} : Vector3{}; };
  const Vector3 origin = vector(pose_1.t), apart = vector(pose_2.t) - origin;
  const Place one{pose_1.R != nullptr ? pose_1.R : kIdentity, {}},
      two{pose_2.R != nullptr ? pose_2.R : kIdentity, apart};
  const double radius = first.radius + second.radius;
  const double size =
      first.extent + second.extent + radius + std::fabs(apart.x) + std::fabs(apart.y) + std::fabs(apart.z);
  const double error = size * (kRounding + 2.5 * (pose_1.defect + pose_2.defect));
  const Found found = find<kFormula>(first, second, one, two, error);
  lower = found.lower - radius - error;
  upper = found.upper - radius + error;
  normal = found.normal;
  point_1 = origin + found.point_1 - found.normal * first.radius;
  point_2 = origin + found.point_2 + found.normal * second.radius;
  is_known = found.is_known && size > kSmallest && size < kLargest;
}

}  // namespace raygauge
