// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/round_pair.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

using round_pair::kIdentity, round_pair::Kind, round_pair::kLonger, round_pair::Place;

// Whether every other way out of a core is more than `longer` longer than the shortest.
bool has_one_way_out(const BoxCore& core, const Vector3& y, double longer) {
  const Vector3 low = y - core.shape.base, high = core.shape.top - y;
  const double room[6] = {low.x, low.y, low.z, high.x, high.y, high.z};
  const double most = *std::min_element(room, room + 6) + longer;
  return std::count_if(room, room + 6, [most](double each) { return each <= most; }) == 1;
}

// Near the axis all ways through the side are as long.
bool has_one_way_out(const FrustumCore& core, const Vector3& y, double longer) {
  constexpr double kBesideAxis = 0.01;  // of the larger radius
  const SpatialShape& shape = core.shape;
  const FrustumCore::Axis<double> axis(shape);
  const Vector3 x = y - shape.base;
  const double down = dot(x, axis.a), full = axis.full(shape), up = full - down;
  const double across = length(axis.without(x)), widening = shape.top_radius - shape.base_radius;
  const double side =
      ((shape.base_radius - across) * full + down * widening) / std::sqrt(full * full + widening * widening);
  if (side + longer < std::min(down, up))
    return across > kBesideAxis * std::max(shape.base_radius, shape.top_radius);
  return std::min(down, up) + longer < std::min(side, std::max(down, up));
}

// In the plane across the shortest axis, inside of the evolute, there are two.
bool has_one_way_out(const EllipsoidCore& core, const Vector3& y, double /*longer*/) {
  constexpr double kBesidePlane = 1e-6;
  const EllipsoidWay way(core.shape.axis, y - core.shape.center);
  return way.t > kBesidePlane * way.least;
}

}  // namespace

// Of a ball and a core: outside of it always; inside where one way out is shorter than all others, and that
// through the side of a core begins well beside its axis.
bool RoundPair::is_differentiable(double value, const SpatialShape& first, const SpatialShape& second,
                                  const PoseNumbers& pose_1, const PoseNumbers& pose_2) noexcept {
  const auto turn = [](const PoseNumbers& pose, const Vector3& x) {
    return Place{pose.R != nullptr ? pose.R : kIdentity, {}}.turn(x);
  };
  if (is_between_ends(first) && is_between_ends(second)) {
    if (is_point(first) || is_point(second)) return true;
    return has_one_way<Formula::segments>(value, first, second, pose_1, pose_2);
  }
  const bool at_second = is_point(first);
  const SpatialShape& core = at_second ? second : first;
  const double away = value + first.radius + second.radius, longer = kLonger * core.extent;
  if (away > longer) return true;
  const PoseNumbers &own = at_second ? pose_2 : pose_1, &other = at_second ? pose_1 : pose_2;
  const auto vector = [](const double* t) { return t != nullptr ? Vector3{t[0], t[1], t[2]} : Vector3{}; };
  const Vector3 way = turn(other, (at_second ? first : second).center) + vector(other.t) - vector(own.t);
  const Vector3 y = Place{own.R != nullptr ? own.R : kIdentity, {}}.turn_back(way);
  if (core.kind == Kind::ellipsoid) return has_one_way_out(EllipsoidCore{core}, y, longer);
  return core.kind == Kind::box ? has_one_way_out(BoxCore{core}, y, longer)
                                : has_one_way_out(FrustumCore{core}, y, longer);
}

}  // namespace raygauge
