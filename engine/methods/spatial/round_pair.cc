// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/round_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/nearest_of_segments.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

// As of SpatialPair, whose chain of operations is longer; a quarter more for the sums of the bounds.
constexpr double kRounding = 320 * 0x1p-53;
constexpr double kSmallest = 1e-70, kLargest = 1e70;

constexpr double kIdentity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

bool has_way_out(const SpatialShape& shape) { return shape.kind == Kind::box || shape.kind == Kind::frustum; }

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

[[gnu::always_inline]] inline Found between_points(const SpatialShape& first, const SpatialShape& second,
                                                   const Place& one, const Place& two, double error) {
  return between(one.turn(first.center), two.turn(second.center) + two.t, error);
}

[[gnu::always_inline]] inline Found between_segments(const SpatialShape& first, const SpatialShape& second,
                                                     const Place& one, const Place& two, double error) {
  const Vector3 p = one.turn(first.center), q = two.turn(second.center) + two.t;
  Vector3 x, y;  // half of each; 0 of a point
  if (!is_point(first)) x = one.turn(first.axis.column[0]);
  if (!is_point(second)) y = two.turn(second.axis.column[0]);
  double s = 0, t = 0;
  nearest_of_segments(p, x, q, y, s, t);
  Found found = between(p + x * s, q + y * t, error);
  found.lower = dot(found.normal, p - q) - std::fabs(dot(found.normal, x)) - std::fabs(dot(found.normal, y));
  return found;
}

// Of a core and a point y in its frame, found: the signed distance, by the support function of the core along
// the normal, and to its surface.
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

// In the half-plane through the axis that holds y: (z, r) along the axis from the base and away from it.
// There the core is a quadrangle with the corners (0, 0), (0, base radius), (full, top radius), (full, 0).
[[gnu::always_inline]] inline FromCore way_from(const FrustumCore& core, const Vector3& y, double error) {
  constexpr double kCancelled = 0.01;  // r²/|x|² below which the way from the axis is turned across it again
  constexpr double kAtAxis = 1e-20;    // ... and below which any way across the axis does
  const SpatialShape& shape = core.shape;
  const Vector3 &a = shape.axis.column[0], x = y - shape.base;
  const double base_radius = shape.base_radius, top_radius = shape.top_radius;
  const double z = dot(x, a), full = dot(shape.top - shape.base, a), widening = top_radius - base_radius;
  Vector3 radial = x - a * z;
  double square = dot(radial, radial), across = std::sqrt(square), share = 1 / across;
  if (!(square > kCancelled * dot(x, x))) {
    radial = radial - a * dot(radial, a);
    across = length(radial);
    if (!(across * across > kAtAxis * dot(x, x))) radial = any_orthogonal(a);
    share = 1 / length(radial);
  }
  FromCore found;
  double along_z = 0, along_r = 0;  // the normal
  const double from_top = z - full, slant = full * full + widening * widening;
  const double beside = (across - base_radius) * full - z * widening;  // of the side, outside of it
  const double foot = z * full + (across - base_radius) * widening;    // on the side
  const bool is_inside = beside <= 0 && z > 0 && from_top < 0;
  if (z <= 0 && across <= base_radius) {
    along_z = -1;
    found.upper = -z;
  } else if (from_top >= 0 && across <= top_radius) {
    along_z = 1;
    found.upper = from_top;
  } else if (is_inside || (foot >= 0 && foot <= slant)) {
    const double scale = 1 / std::sqrt(slant);
    found.upper = beside * scale;
    along_z = -widening * scale;
    along_r = full * scale;
    if (is_inside && std::max(-z, from_top) >= found.upper) {
      found.upper = std::max(-z, from_top);
      along_z = -z > from_top ? -1.0 : 1.0;
      along_r = 0;
    }
  } else {
    const double way_z = foot < 0 ? z : from_top, way_r = across - (foot < 0 ? base_radius : top_radius);
    found.upper = std::sqrt(way_z * way_z + way_r * way_r);
    found.is_known = found.upper > error;
    along_z = way_z / found.upper;
    along_r = way_r / found.upper;
  }
  found.outward = a * along_z + radial * (along_r * share);
  found.lower =
      dot(found.outward, x) - std::max(along_r * base_radius, along_z * full + along_r * top_radius);
  return found;
}

// Of core kAt and the centre of a ball.
template <int kAt, class Core>
[[gnu::always_inline]] inline Found from_core(const Core& core, const Vector3& ball_center, const Place& own,
                                              const Place& other, double error) {
  const Vector3 center = other.turn(ball_center) + other.t;
  const FromCore way = way_from(core, own.turn_back(center - own.t), error);
  const Vector3 outward = own.turn(way.outward), on_core = center - outward * way.upper;
  if constexpr (kAt == 0) return {way.lower, way.upper, -outward, on_core, center, way.is_known};
  return {way.lower, way.upper, outward, center, on_core, way.is_known};
}

// Whether every other way out of a core is more than `longer` longer than the shortest.
bool has_one_way_out(const BoxCore& core, const Vector3& y, double longer) {
  const Vector3 low = y - core.shape.base, high = core.shape.top - y;
  double room[6] = {low.x, low.y, low.z, high.x, high.y, high.z};
  std::partial_sort(room, room + 2, room + 6);
  return room[0] + longer < room[1];
}

// Near the axis all ways through the side are as long.
bool has_one_way_out(const FrustumCore& core, const Vector3& y, double longer) {
  constexpr double kBesideAxis = 0.01;  // of the larger radius
  const SpatialShape& shape = core.shape;
  const FrustumCore::Axis<double> axis(shape);
  const Vector3 x = y - shape.base;
  const double down = dot(x, axis.a), full = axis.full(shape), up = full - down;
  const double across = length(axis.without(x)), widening = shape.top_radius - shape.base_radius;
  const double side = ((shape.base_radius - across) * full + down * widening) / std::hypot(full, widening);
  if (side + longer < std::min(down, up))
    return across > kBesideAxis * std::max(shape.base_radius, shape.top_radius);
  return std::min(down, up) + longer < std::min(side, std::max(down, up));
}

}  // namespace

bool RoundPair::has_formula(const SpatialShape& first, const SpatialShape& second) noexcept {
  if (is_between_ends(first)) return is_between_ends(second) || (is_point(first) && has_way_out(second));
  return has_way_out(first) && is_point(second);
}

// One function for each formula: what all begin with is little, and the compiler keeps it in registers.
template <class Find>
[[gnu::always_inline]] inline bool RoundPair::solve_by(const Find& find, const SpatialShape& first,
                                                       const SpatialShape& second, const PoseNumbers& pose_1,
                                                       const PoseNumbers& pose_2) noexcept {
  const auto vector = [](const double* t) { return t != nullptr ? Vector3{t[0], t[1], t[2]} : Vector3{}; };
  const Vector3 origin = vector(pose_1.t), apart = vector(pose_2.t) - origin;
  const Place one{pose_1.R != nullptr ? pose_1.R : kIdentity, {}},
      two{pose_2.R != nullptr ? pose_2.R : kIdentity, apart};
  const double radius = first.radius + second.radius;
  const double size =
      first.extent + second.extent + radius + std::fabs(apart.x) + std::fabs(apart.y) + std::fabs(apart.z);
  const double error = size * (kRounding + 2.5 * (pose_1.defect + pose_2.defect));
  const Found found = find(one, two, error);
  lower_ = found.lower - radius - error;
  upper_ = found.upper - radius + error;
  normal_ = found.normal;
  point_1_ = origin + found.point_1 - found.normal * first.radius;
  point_2_ = origin + found.point_2 + found.normal * second.radius;
  return found.is_known && size > kSmallest && size < kLargest;
}

bool RoundPair::solve(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                      const PoseNumbers& pose_2) noexcept {
  if (is_point(first) && is_point(second)) return solve_points(first, second, pose_1, pose_2);
  if (is_between_ends(first) && is_between_ends(second)) return solve_segments(first, second, pose_1, pose_2);
  const int at = is_point(first) ? 1 : 0;
  const bool is_box = (at == 0 ? first : second).kind == Kind::box;
  if (is_box)
    return at == 0 ? solve_core<BoxCore, 0>(first, second, pose_1, pose_2)
                   : solve_core<BoxCore, 1>(first, second, pose_1, pose_2);
  return at == 0 ? solve_core<FrustumCore, 0>(first, second, pose_1, pose_2)
                 : solve_core<FrustumCore, 1>(first, second, pose_1, pose_2);
}

[[gnu::noinline]] bool RoundPair::solve_points(const SpatialShape& first, const SpatialShape& second,
                                               const PoseNumbers& pose_1,
                                               const PoseNumbers& pose_2) noexcept {
  return solve_by([&](const Place& one, const Place& two,
                      double error) { return between_points(first, second, one, two, error); },
                  first, second, pose_1, pose_2);
}

[[gnu::noinline]] bool RoundPair::solve_segments(const SpatialShape& first, const SpatialShape& second,
                                                 const PoseNumbers& pose_1,
                                                 const PoseNumbers& pose_2) noexcept {
  return solve_by([&](const Place& one, const Place& two,
                      double error) { return between_segments(first, second, one, two, error); },
                  first, second, pose_1, pose_2);
}

template <class Core, int kAt>
[[gnu::noinline]] bool RoundPair::solve_core(const SpatialShape& first, const SpatialShape& second,
                                             const PoseNumbers& pose_1, const PoseNumbers& pose_2) noexcept {
  return solve_by(
      [&](const Place& one, const Place& two, double error) {
        if constexpr (kAt == 0)
          return from_core<0>(Core{first}, second.center, one, two, error);
        else
          return from_core<1>(Core{second}, first.center, two, one, error);
      },
      first, second, pose_1, pose_2);
}

// Of a ball and a core: outside of it always; inside where one way out is shorter than all others, and that
// through the side of a core begins well beside its axis.
bool RoundPair::is_differentiable(const SpatialShape& first, const SpatialShape& second,
                                  const PoseNumbers& pose_1, const PoseNumbers& pose_2) const noexcept {
  constexpr double kParallel = 1e-6, kLonger = 1e-9;
  const auto turn = [](const PoseNumbers& pose, const Vector3& x) {
    return Place{pose.R != nullptr ? pose.R : kIdentity, {}}.turn(x);
  };
  if (is_between_ends(first) && is_between_ends(second)) {
    if (is_point(first) || is_point(second)) return true;
    const Vector3 x = turn(pose_1, first.axis.column[0]), y = turn(pose_2, second.axis.column[0]);
    const Vector3 across = cross(x, y);
    return dot(across, across) > kParallel * kParallel * dot(x, x) * dot(y, y);
  }
  const bool at_second = is_point(first);
  const SpatialShape& core = at_second ? second : first;
  const double away = 0.5 * (lower_ + upper_) + first.radius + second.radius, longer = kLonger * core.extent;
  if (away > longer) return true;
  const PoseNumbers &own = at_second ? pose_2 : pose_1, &other = at_second ? pose_1 : pose_2;
  const auto vector = [](const double* t) { return t != nullptr ? Vector3{t[0], t[1], t[2]} : Vector3{}; };
  const Vector3 way = turn(other, (at_second ? first : second).center) + vector(other.t) - vector(own.t);
  const Vector3 y = Place{own.R != nullptr ? own.R : kIdentity, {}}.turn_back(way);
  return core.kind == Kind::box ? has_one_way_out(BoxCore{core}, y, longer)
                                : has_one_way_out(FrustumCore{core}, y, longer);
}

}  // namespace raygauge
