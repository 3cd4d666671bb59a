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

bool is_segment(const SpatialShape& shape) {
  return shape.kind == Kind::point || shape.kind == Kind::segment;
}
bool has_way_out(const SpatialShape& shape) { return shape.kind == Kind::box || shape.kind == Kind::frustum; }

// Half of the segment; zero of a point.
Vector3 half_of(const SpatialShape& shape) {
  return shape.kind == Kind::segment ? shape.axis.column[0] : Vector3{};
}

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
  Vector3 normal, point[2];
  bool is_known = false;
};

// All but the lower bound.
[[gnu::always_inline]] inline void finish(double error, Found& found) {
  const Vector3 way = found.point[0] - found.point[1];
  found.upper = length(way);
  found.is_known = found.upper > error;
  found.normal = way * (1 / found.upper);
}

[[gnu::always_inline]] inline Found between_points(const SpatialShape& first, const SpatialShape& second,
                                                   const Place& one, const Place& two, double error) {
  Found found;
  found.point[0] = one.turn(first.center);
  found.point[1] = two.turn(second.center) + two.t;
  finish(error, found);
  found.lower = dot(found.normal, found.point[0] - found.point[1]);
  return found;
}

[[gnu::always_inline]] inline Found between_segments(const SpatialShape& first, const SpatialShape& second,
                                                     const Place& one, const Place& two, double error) {
  Found found;
  const Vector3 p = one.turn(first.center), q = two.turn(second.center) + two.t;
  const Vector3 x = one.turn(half_of(first)), y = two.turn(half_of(second));
  double s = 0, t = 0;
  nearest_of_segments(p, x, q, y, s, t);
  found.point[0] = p + x * s;
  found.point[1] = q + y * t;
  finish(error, found);
  found.lower = dot(found.normal, p - q) - std::fabs(dot(found.normal, x)) - std::fabs(dot(found.normal, y));
  return found;
}

// Of core `at` and the centre of a ball, in the frame of the core.
template <class Core>
[[gnu::always_inline]] inline Found from_core(const Core& core, int at, const Vector3& ball_center,
                                              const Place& own, const Place& other, double error) {
  Found found;
  const Vector3 center = other.turn(ball_center) + other.t;
  const Vector3 y = own.turn_back(center - own.t);
  Vector3 on_core = core.nearest(y), outward = y - on_core;
  const double away = length(outward);
  if (away > 0) {
    outward = outward * (1 / away);
    found.upper = away;
  } else {
    found.upper = -core.way_out(y, outward);
    on_core = y - outward * found.upper;
  }
  found.is_known = !(away > 0) || away > error;
  const auto view = core.look(outward, InstructionSet::automatic);
  found.lower = dot(outward, y) - view.height(view.index);
  found.normal = own.turn(at == 0 ? -outward : outward);
  found.point[at] = own.turn(on_core) + own.t;
  found.point[1 - at] = center;
  return found;
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
  if (is_segment(first)) return is_segment(second) || (is_point(first) && has_way_out(second));
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
  point_1_ = origin + found.point[0] - found.normal * first.radius;
  point_2_ = origin + found.point[1] + found.normal * second.radius;
  return found.is_known && size > kSmallest && size < kLargest;
}

bool RoundPair::solve(const SpatialShape& first, const SpatialShape& second, const PoseNumbers& pose_1,
                      const PoseNumbers& pose_2) noexcept {
  if (is_point(first) && is_point(second)) return solve_points(first, second, pose_1, pose_2);
  if (is_segment(first) && is_segment(second)) return solve_segments(first, second, pose_1, pose_2);
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
          return from_core(Core{first}, 0, second.center, one, two, error);
        else
          return from_core(Core{second}, 1, first.center, two, one, error);
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
  if (is_point(first) && is_point(second)) return true;
  if (is_segment(first) && is_segment(second)) {
    if (is_point(first) || is_point(second)) return true;
    const Vector3 x = turn(pose_1, half_of(first)), y = turn(pose_2, half_of(second)), across = cross(x, y);
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
