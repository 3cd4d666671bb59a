// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/mesh_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/meshes/triangle_pair.h"
#include "raygauge/meshes/mesh.h"

namespace raygauge {
namespace {

constexpr std::size_t kKept = 6;     // planes
constexpr double kTolerance = 1e-2;  // of a distance of which the direction alone is used

Vector3 center_of(const BoxNode& box) { return vector_of(box.center); }

double radius_of(const BoxNode& box) {
  const double x = double{box.half[0]}, y = double{box.half[1]}, z = double{box.half[2]};
  return std::sqrt(x * x + y * y + z * z) * (1 + 4 * BoxNode::kAxisError);
}

double top_of(const BoxNode& box, const Vector3& u) {
  double top = dot(center_of(box), u);
  for (int k = 0; k < 3; ++k) top += std::fabs(dot(vector_of(box.axis[k]), u)) * double{box.half[k]};
  return top;
}

double top_of(const TriangleCorners& t, const Vector3& u) {
  return std::max({dot(t.corner[0], u), dot(t.corner[1], u), dot(t.corner[2], u)});
}

double top_of(const ConvexSet& set, const Vector3& u) {
  const double direction[3] = {u.x, u.y, u.z};
  double point[3];
  return set.support_unchecked(direction, point);
}

double distance_to_segment(const Vector3& first, const Vector3& last) {
  const Vector3 way = last - first;
  const double square = dot(way, way), along = -dot(first, way);
  if (along <= 0 || square == 0) return length(first);
  if (along >= square) return length(last);
  return length(first + way * (along / square));
}

DistanceOptions general_options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = kTolerance;
  return options;
}

}  // namespace

MeshSweep::MeshSweep() : pose_a_(3), pose_b_(3), ball_(Vector::Zero(3), 1.0), general_(general_options()) {}

MeshSweep::Side MeshSweep::side_of(const EdgeShape& shape) {
  Side side;
  side.mesh = as_mesh(*shape.part->set);
  if (side.mesh != nullptr) return side;
  side.set = shape.part->set.get();
  side.box = BoxNode::around(shape.low.data(), shape.high.data());
  side.box.count = 1;
  return side;
}

void MeshSweep::bind(const EdgeShape& a, const EdgeShape& b) {
  a_ = side_of(a);
  b_ = side_of(b);
}

bool MeshSweep::apart(const SweepMoments& moments, const Sagging& sagging, double enough,
                      const MeshWarmStart& nearest) {
  at_ = &moments;
  sagging_ = sagging;
  enough_ = enough;
  kept_.clear();
  open_.clear();
  const bool known = nearest.triangle_1 >= 0 && nearest.triangle_1 < a_.pieces() && nearest.triangle_2 >= 0 &&
                     nearest.triangle_2 < b_.pieces();
  if (known && !pieces_apart(nearest.triangle_1, nearest.triangle_2)) return false;
  open_.push_back({0, 0});
  while (!open_.empty()) {
    const NodePair pair = open_.back();
    open_.pop_back();
    const BoxNode &one = a_.node(pair.one), &two = b_.node(pair.two);
    if (boxes_apart(one, two)) continue;
    if (!one.is_leaf() || !two.is_leaf()) {
      open(pair);
    } else if (!leaves_apart(one, two)) {
      return false;
    }
  }
  return true;
}

void MeshSweep::open(const NodePair& pair) {
  const BoxNode &one = a_.node(pair.one), &two = b_.node(pair.two);
  if (two.is_leaf() || (!one.is_leaf() && one.size() > two.size())) {
    open_.push_back({one.next, pair.two});
    open_.push_back({pair.one + 1, pair.two});
  } else {
    open_.push_back({pair.one, two.next});
    open_.push_back({pair.one, pair.two + 1});
  }
}

MeshSweep::Plane MeshSweep::plane_across(const Vector3& u) const {
  Plane plane;
  plane.u = u;
  for (int end = 0; end < 2; ++end) {
    const int moment = 2 * end;
    plane.of_a[end] = at_->R_a[moment].transposed_times(u);
    plane.of_b[end] = -at_->R_b[moment].transposed_times(u);
    plane.along[end] = dot(u, at_->way[moment]) - a_.radius() - b_.radius();
    plane.top_of_set[end] = 0;
  }
  return plane;
}

// Its support function holds for all boxes and triangles of the mesh.
void MeshSweep::measure_set(Plane& plane) const {
  for (int end = 0; end < 2; ++end) {
    if (a_.set != nullptr) plane.top_of_set[end] = top_of(*a_.set, plane.of_a[end]);
    if (b_.set != nullptr) plane.top_of_set[end] = top_of(*b_.set, plane.of_b[end]);
  }
}

void MeshSweep::keep(Plane plane) {
  measure_set(plane);
  last_ = kept_.size() < kKept ? kept_.size() : (last_ + 1) % kKept;
  if (last_ == kept_.size()) kept_.emplace_back();
  kept_[last_] = plane;
}

bool MeshSweep::proves(double before, double after) const noexcept {
  return before > enough_ && after > enough_ && least_between(before, after, sagging_) > enough_;
}

bool MeshSweep::sets_apart(const Plane& plane, const BoxNode& one, const BoxNode& two, bool with_set) const {
  double gap[2];
  for (int end = 0; end < 2; ++end) {
    gap[end] = plane.along[end];
    if (with_set) gap[end] -= plane.top_of_set[end];
    if (!with_set || a_.set == nullptr) gap[end] -= top_of(one, plane.of_a[end]);
    if (!with_set || b_.set == nullptr) gap[end] -= top_of(two, plane.of_b[end]);
    if (!(gap[end] > enough_)) return false;
  }
  return proves(gap[0], gap[1]);
}

bool MeshSweep::boxes_apart(const BoxNode& one, const BoxNode& two) {
  const Vector3 c = center_of(one), d = center_of(two);
  const auto between = [&](int moment) {
    return at_->way[moment] + at_->R_b[moment] * d - at_->R_a[moment] * c;
  };
  const Vector3 before = between(0), after = between(2);
  const double around = radius_of(one) + radius_of(two) + a_.radius() + b_.radius();
  if (distance_to_segment(before, after) > (around + enough_ + sagging_.sag + sagging_.drift) * (1 + 1e-13))
    return true;
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const Plane& plane = kept_[(last_ + kept_.size() - k) % kept_.size()];
    if (sets_apart(plane, one, two, true)) return true;
  }
  const Vector3 apart = before + after;
  for (int k = 0; k < 7; ++k) {
    Vector3 u = apart;
    if (k > 0 && k < 4) u = at_->R_a[1] * vector_of(one.axis[k - 1]);
    if (k >= 4) u = at_->R_b[1] * vector_of(two.axis[k - 4]);
    const double size = length(u);
    if (!(size > 0)) continue;
    u = u * ((dot(u, apart) < 0 ? -1 : 1) / size);
    const Plane plane = plane_across(u);
    if (!sets_apart(plane, one, two, false)) continue;
    keep(plane);
    return true;
  }
  return false;
}

bool MeshSweep::leaves_apart(const BoxNode& one, const BoxNode& two) {
  const std::int32_t first = one.next, second = two.next;
  for (std::int32_t k = second; k < second + two.count; ++k) {
    for (std::int32_t i = first; i < first + one.count; ++i) {
      if (!pieces_apart(i, k)) return false;
    }
  }
  return true;
}

bool MeshSweep::sets_pieces_apart(const Plane& plane, std::int32_t one, std::int32_t two) const {
  double gap[2];
  for (int end = 0; end < 2; ++end) {
    gap[end] = plane.along[end] - plane.top_of_set[end];
    if (a_.mesh != nullptr) gap[end] -= top_of(a_.mesh->tree().triangle(one), plane.of_a[end]);
    if (b_.mesh != nullptr) gap[end] -= top_of(b_.mesh->tree().triangle(two), plane.of_b[end]);
  }
  return proves(gap[0], gap[1]);
}

bool MeshSweep::pieces_apart(std::int32_t one, std::int32_t two) {
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const Plane& plane = kept_[(last_ + kept_.size() - k) % kept_.size()];
    if (sets_pieces_apart(plane, one, two)) return true;
  }
  Vector3 u;
  if (!direction_of(one, two, u)) return false;
  keep(plane_across(u));
  return sets_pieces_apart(kept_[last_], one, two);
}

// That of their distance in the middle.
bool MeshSweep::direction_of(std::int32_t one, std::int32_t two, Vector3& u) {
  const Matrix3 &R_a = at_->R_a[1], &R_b = at_->R_b[1];
  if (a_.mesh != nullptr && b_.mesh != nullptr) {
    TriangleCorners first = a_.mesh->tree().triangle(one), second = b_.mesh->tree().triangle(two);
    for (Vector3& corner : first.corner) corner = R_a * corner;
    for (Vector3& corner : second.corner) corner = R_b * corner + at_->way[1];
    Vector3 from = second.corner[0] - first.corner[0];
    if (!(dot(from, from) > 0)) from = {1, 0, 0};
    u = triangle_distance(first, second, from, kTolerance, std::numeric_limits<double>::infinity()).normal;
    return dot(u, u) > 0;
  }
  const bool mesh_first = a_.mesh != nullptr;
  triangle_.assign(mesh_first ? *a_.mesh : *b_.mesh, mesh_first ? one : two);
  const ConvexSet& set_a = mesh_first ? triangle_ : *a_.set;
  const ConvexSet& set_b = mesh_first ? *b_.set : triangle_;
  const Vector3 zero;
  const double *turn_a = &R_a.column[0].x, *turn_b = &R_b.column[0].x, *way = &at_->way[1].x;
  if (solve_.bind(set_a, set_b, InstructionSet::automatic) &&
      solve_.place({turn_a, &zero.x, 0}, {turn_b, way, 0})) {
    solve_.distance(kTolerance, nullptr);
    const double* n = solve_.normal();
    u = {-n[0], -n[1], -n[2]};
    return solve_.answer().bounds.lower() > 0;
  }
  pose_a_.assign_checked(turn_a, &zero.x, 0);
  pose_b_.assign_checked(turn_b, way, 0);
  const DistanceResult& found = general_.solve({set_a, pose_a_}, {set_b, pose_b_}, ball_).distance;
  if (!(found.lower > 0) || found.normal.size() != 3) return false;
  const Vector3 n{found.normal[0], found.normal[1], found.normal[2]};
  u = n * (-1 / length(n));
  return true;
}

}  // namespace raygauge
