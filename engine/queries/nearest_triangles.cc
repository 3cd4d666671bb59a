// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/nearest_triangles.h"

#include <algorithm>
#include <cmath>

#include "engine/meshes/triangle_pair.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;

DistanceOptions general_options(const DistanceOptions& options) {
  DistanceOptions general = options;
  general.time_limit = kInfinity;  // its own stop keeps that of the search
  return general;
}

Posed posed(const ConvexSet& set, const Pose* pose) {
  return pose == nullptr ? Posed(set) : Posed(set, *pose);
}

}  // namespace

NearestTriangles::NearestTriangles(const DistanceOptions& options, const Stopwatch& watch)
    : options_(options), ball_(Vector::Zero(3), 1.0), general_(general_options(options)) {
  general_.set_stop([&watch] { return watch.expired(); });
}

void NearestTriangles::begin(const MeshPair& pair, double enough) {
  pair_ = &pair;
  enough_ = target_ = enough;
  passed_over_ = has_plane_ = false;
  points_ = Points::unknown;
  found = {};
  found.lower = found.upper = kInfinity;
  counters = {};
  if (pair.half_space_2 == nullptr) return;
  // Its plane is the only one: x in the first frame is u·x above it, u pointing into the half-space, and all
  // of it has u·x >= plane_of_.
  const Vector& n = pair.half_space_2->normal();
  const Vector3 normal{n[0], n[1], n[2]};
  const double size = length(normal);
  plane_ = pair.R * normal * (-1 / size);
  plane_of_ = dot(plane_, pair.t) - pair.half_space_2->offset() / size;
  has_plane_ = true;
}

void NearestTriangles::leave_open(double lower) noexcept {
  found.out_of_time = true;
  found.lower = std::min(found.lower, std::max(0.0, lower - pair_->margin));
}

void NearestTriangles::end_search() noexcept {
  if (passed_over_) found.lower = std::min(found.lower, target_);
}

void NearestTriangles::look_at(std::int32_t one, std::int32_t two, const TriangleCorners& turned) {
  ++counters.triangle_pairs;
  Vector3 from = found.normal;
  if (!(dot(from, from) > 0)) from = turned.corner[0] - pair_->tree_1().triangle(one).corner[0];
  look_at(one, two, turned, from);
}

void NearestTriangles::look_at(std::int32_t one, std::int32_t two, const TriangleCorners& turned,
                               const Vector3& from) {
  const double radii = pair_->radii, radius_1 = pair_->radius_1, margin = pair_->margin;
  const TriangleDistance answer =
      triangle_distance(pair_->tree_1().triangle(one), turned, dot(from, from) > 0 ? from : Vector3{1, 0, 0},
                        options_.tolerance * 0.5, target_ + margin + radii);
  if (is_beyond(answer.lower - radii)) return pass_over();
  if (answer.upper + margin < radii) return meet(one, two);
  const double lower = (answer.lower - radii - margin) * kDown, upper = (answer.upper - radii + margin) * kUp;
  if (!(lower > 0 && upper - lower <= options_.tolerance * upper)) return solve_precisely(one, two);
  if (upper < found.upper) {
    const Vector3 way = answer.point_2 - answer.point_1;
    point_1_ = answer.point_1 + way * (radius_1 / answer.upper);
    point_2_ = answer.point_2 - way * ((radii - radius_1) / answer.upper);
    found.normal = answer.normal;
    points_ = Points::in_first;
  }
  take(lower, upper, one, two);
}

void NearestTriangles::look_at_body(std::int32_t one) {
  ++counters.triangle_pairs;
  const TriangleCorners& a = pair_->tree_1().triangle(one);
  if (has_plane_) {
    const double top =
        std::max({dot(plane_, a.corner[0]), dot(plane_, a.corner[1]), dot(plane_, a.corner[2])});
    if (is_beyond(plane_of_ - top - pair_->radius_1)) return pass_over();
  }
  solve_precisely(one, 0);
}

double NearestTriangles::plane_distance(const BoxNode& one) const noexcept {
  if (!has_plane_) return -kInfinity;
  double top = dot(plane_, vector_of(one.center));
  for (int k = 0; k < 3; ++k) top += std::fabs(dot(plane_, vector_of(one.axis[k]))) * double{one.half[k]};
  return plane_of_ - top - pair_->radius_1;
}

void NearestTriangles::take(double lower, double upper, std::int32_t one, std::int32_t two) {
  found.lower = std::min(found.lower, std::max(lower, 0.0));
  if (!(upper < found.upper)) return;
  found.upper = upper;
  found.nearest_1 = one;
  found.nearest_2 = two;
  target_ = std::min(enough_, upper * (1 - options_.tolerance) * kUp);
}

// u proves a distance, and points from 1 to 2.
void NearestTriangles::take_normal(const double* from_2_to_1, bool nearer) {
  const Vector3 u = -pair_->W.transposed_times({from_2_to_1[0], from_2_to_1[1], from_2_to_1[2]});
  if (nearer) found.normal = u;
  if (pair_->body_2 == nullptr || pair_->half_space_2 != nullptr) return;
  const Vector3 v = pair_->R.transposed_times(u);
  const double down[3] = {-v.x, -v.y, -v.z};
  double lowest[3];
  plane_ = u;
  plane_of_ = dot(u, pair_->t) - pair_->body_2->support_unchecked(down, lowest);
  has_plane_ = true;
}

const ConvexSet& NearestTriangles::second_set(std::int32_t two) {
  if (pair_->mesh_2 == nullptr) return *pair_->body_2;
  triangle_[1].assign(*pair_->mesh_2, two);
  return triangle_[1];
}

void NearestTriangles::solve_precisely(std::int32_t one, std::int32_t two) {
  ++counters.precise_pairs;
  triangle_[0].assign(*pair_->first, one);
  if (!solve_.bind(triangle_[0], second_set(two), options_.instruction_set) ||
      !solve_.place(PoseNumbers(pair_->pose_1), PoseNumbers(pair_->pose_2)))
    return solve_generally(one, two);
  const bool done = solve_.distance(options_.tolerance, nullptr);
  const SpatialAnswer& answer = solve_.answer();
  if (answer.end == SpatialEnd::intersecting) return meet(one, two);
  const bool nearer = answer.bounds.upper() < found.upper;
  if (answer.bounds.lower() > 0) take_normal(solve_.normal(), nearer);
  if (nearer) {
    points_ = done ? Points::in_world : Points::unknown;
    if (done) solve_.closest_points(world_point_[0], world_point_[1]);
  }
  take(answer.bounds.lower(), answer.bounds.upper(), one, two);
}

void NearestTriangles::solve_generally(std::int32_t one, std::int32_t two) {
  const ObjectDistance& answer =
      general_.solve(posed(triangle_[0], pair_->pose_1), posed(second_set(two), pair_->pose_2), ball_,
                     ObjectEffects::closest_points);
  if (answer.distance.status == DistanceStatus::contains_origin) return meet(one, two);
  const bool nearer = answer.distance.upper < found.upper;
  if (answer.distance.lower > 0 && answer.distance.normal.size() == 3)
    take_normal(answer.distance.normal.data(), nearer);
  if (nearer) {
    points_ = answer.closest_point_1.size() == 3 ? Points::in_world : Points::unknown;
    for (int k = 0; k < 3 && points_ == Points::in_world; ++k) {
      world_point_[0][k] = answer.closest_point_1[k];
      world_point_[1][k] = answer.closest_point_2[k];
    }
  }
  take(answer.distance.lower, answer.distance.upper, one, two);
}

void NearestTriangles::meet(std::int32_t one, std::int32_t two) {
  found.meets = true;
  found.nearest_1 = one;
  found.nearest_2 = two;
}

bool NearestTriangles::closest_points(double (*points)[3]) const {
  const Vector3 of_first[2] = {point_1_, point_2_};
  for (int i = 0; i < 2; ++i) {
    std::copy_n(world_point_[i], 3, points[i]);
    if (points_ != Points::in_first) continue;
    const Vector3 x = pair_->W * of_first[i] + pair_->w;
    points[i][0] = x.x;
    points[i][1] = x.y;
    points[i][2] = x.z;
  }
  return points_ != Points::unknown;
}

bool NearestTriangles::nearest_meet(const Pose& pose_2) {
  triangle_[0].assign(*pair_->first, found.nearest_1);
  const ObjectDistance& there =
      general_.solve(posed(triangle_[0], pair_->pose_1), {second_set(found.nearest_2), pose_2}, ball_);
  return there.distance.status == DistanceStatus::contains_origin;
}

}  // namespace raygauge
