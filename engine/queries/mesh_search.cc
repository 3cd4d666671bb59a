// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/mesh_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/meshes/triangle_pair.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kSmallest = 1e-70,
                 kLargest = 1e71;  // of what is squared and multiplied up to the fourth power
constexpr double kSmallestSingle = 1e-6,
                 kLargestSingle = 1e8;       // of what is so in single precision
constexpr double kOfSingle = 0x1p-16;        // see Kernels::bound_boxes
constexpr double kRounding = 256 * 0x1p-53;  // as of SpatialPair
constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr std::size_t kFirstRoom = 1024;

void read(const Pose* pose, Matrix3& R, Vector3& t) {
  R = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  t = {};
  if (pose == nullptr) return;
  const double *r = pose->rotation_data(), *x = pose->translation_data();
  R = {{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}}};
  t = {x[0], x[1], x[2]};
}

double defect_of(const Pose* pose) { return pose == nullptr ? 0 : pose->defect(); }

constexpr double kApart = std::numeric_limits<double>::min();

DistanceOptions general_options(const DistanceOptions& options) {
  DistanceOptions general = options;
  general.time_limit = kInfinity;  // its own stop keeps that of the search
  return general;
}

}  // namespace

MeshSearch::MeshSearch(const DistanceOptions& options)
    : options_(options),
      kernels_(kernels_for(options.instruction_set)),
      ball_(Vector::Zero(3), 1.0),
      general_(general_options(options)) {
  open_.reserve(kFirstRoom);
  wide_open_.reserve(kFirstRoom);
  general_.set_stop([this] { return watch_.expired(); });
}

const ObjectDistance& MeshSearch::distance(const PosedMesh& A1, const PosedMesh& A2, ObjectEffects effects,
                                           MeshWarmStart* warm) {
  begin(A1, A2.pose);
  set_other(A2.mesh);
  search(kInfinity, warm);
  return finish(effects, warm);
}

const ObjectDistance& MeshSearch::distance(const PosedMesh& A1, const Posed& A2, ObjectEffects effects,
                                           MeshWarmStart* warm) {
  begin(A1, A2.pose);
  set_other(A2.set);
  search(kInfinity, warm);
  return finish(effects, warm);
}

Separation MeshSearch::separation(const PosedMesh& A1, const PosedMesh& A2, MeshWarmStart* warm) {
  begin(A1, A2.pose);
  set_other(A2.mesh);
  search(kApart, warm);
  return separation_found(warm);
}

Separation MeshSearch::separation(const PosedMesh& A1, const Posed& A2, MeshWarmStart* warm) {
  begin(A1, A2.pose);
  set_other(A2.set);
  search(kApart, warm);
  return separation_found(warm);
}

void MeshSearch::begin(const PosedMesh& A1, const Pose* pose_2) {
  watch_.start(options_.time_limit, &stop_);
  looks_ = 0;
  counters_ = {};
  first_ = &A1.mesh;
  pose_1_ = A1.pose;
  pose_2_ = pose_2;
  out_of_time_ = meets_ = passed_over_ = has_plane_ = other_.is_half_space = false;
  inside_by_ = 0;
  points_ = Points::unknown;
  nearest_1_ = nearest_2_ = -1;
  normal_ = {};
  lower_ = upper_ = kInfinity;
  radius_1_ = radii_ = A1.mesh.radius();
}

void MeshSearch::set_other(const Mesh& mesh) {
  other_.mesh = &mesh;
  other_.body = nullptr;
  other_.tree = &mesh.tree();
  place();
  radii_ += mesh.radius();
  measure(mesh.tree().extent());
}

// How large the numbers are, and so their errors.
void MeshSearch::measure(double size_of_second) {
  const double size = first_->tree().extent() + size_of_second + length(t_) + radii_;
  margin_ = size * (kRounding + 2 * (defect_of(pose_1_) + defect_of(pose_2_)));
  in_range_ = size > kSmallest && size < kLargest;
  single_slack_ = size * kOfSingle + radii_;
  in_single_range_ = size > kSmallestSingle && size < kLargestSingle;
}

void MeshSearch::set_other(const ConvexSet& body) {
  other_.mesh = nullptr;
  other_.tree = nullptr;
  other_.body = &body;
  if (const HalfSpace* half_space = as_half_space(body)) return set_half_space(*half_space);
  double magnitude[3], low[3], high[3], square = 0;
  body.magnitude_unchecked(magnitude);
  for (int k = 0; k < 3; ++k) {
    double u[3] = {0, 0, 0}, point[3];
    const double error = ConvexSet::rounding_error(3) * magnitude[k] * 2;
    u[k] = 1;
    high[k] = body.support_unchecked(u, point) + error;
    u[k] = -1;
    low[k] = -body.support_unchecked(u, point) - error;
    const double far = std::max({std::fabs(high[k]), std::fabs(low[k]), magnitude[k]});
    square += far * far;
  }
  other_.box = BoxNode::around(low, high);
  other_.box.next = 0;
  other_.box.count = 1;
  place();
  measure(std::sqrt(square));
}

// Its plane is the only one: x in the first frame is u·x above it, u pointing into the half-space, and all of
// it has u·x >= plane_of_.
void MeshSearch::set_half_space(const HalfSpace& half_space) {
  const Vector& n = half_space.normal();
  const Vector3 normal{n[0], n[1], n[2]};
  const double size_of_normal = length(normal), offset = half_space.offset() / size_of_normal;
  other_.box = {};
  other_.box.count = 1;
  place();
  plane_ = R_ * normal * (-1 / size_of_normal);
  plane_of_ = dot(plane_, t_) - offset;
  has_plane_ = other_.is_half_space = true;
  measure(std::fabs(offset));
}

void MeshSearch::place() {
  Matrix3 R;
  Vector3 t;
  read(pose_1_, W_, w_);
  read(pose_2_, R, t);
  for (int j = 0; j < 3; ++j) R_.column[j] = W_.transposed_times(R.column[j]);
  t_ = W_.transposed_times(t - w_);
}

void MeshSearch::search(double enough, MeshWarmStart* warm) {
  if (!in_range_) {
    lower_ = 0;
    return;
  }
  enough_ = target_ = std::max(enough, 2 * kClearMargins * margin_);
  look_around(warm);
  other_.tree != nullptr&& in_single_range_ ? search_wide() : search_boxes();
  if (passed_over_) lower_ = std::min(lower_, target_);
  if (!meets_) locate();
}

// With pairs at least so far apart left open.
void MeshSearch::note_out_of_time(double lower) {
  out_of_time_ = true;
  lower_ = std::min(lower_, std::max(0.0, lower - margin_));
}

// The nearest triangles of the last solve.
void MeshSearch::look_around(MeshWarmStart* warm) {
  if (warm == nullptr || warm->triangle_1 < 0 || warm->triangle_1 >= first_->size()) return;
  const bool two = other_.tree == nullptr ? warm->triangle_2 == 0
                                          : warm->triangle_2 >= 0 && warm->triangle_2 < other_.tree->size();
  if (!two) return;
  turn_second(warm->triangle_2);
  look_at(warm->triangle_1, warm->triangle_2);
}

// Into the first frame.
void MeshSearch::turn_second(std::int32_t two) {
  if (other_.tree == nullptr) return;
  const TriangleCorners& given = other_.tree->triangle(two);
  for (int c = 0; c < 3; ++c) turned_.corner[c] = to_first(given.corner[c]);
}

// After turn_second().
void MeshSearch::look_at(std::int32_t one, std::int32_t two) {
  ++counters_.triangle_pairs;
  if (other_.tree == nullptr) return look_at_body(one);
  Vector3 from = normal_;
  if (!(dot(from, from) > 0)) from = turned_.corner[0] - first_->tree().triangle(one).corner[0];
  look_at_triangles(one, two, from);
}

void MeshSearch::look_at_triangles(std::int32_t one, std::int32_t two, const Vector3& from) {
  const TriangleCorners &a = first_->tree().triangle(one), &b = turned_;
  const TriangleDistance found = triangle_distance(a, b, dot(from, from) > 0 ? from : Vector3{1, 0, 0},
                                                   options_.tolerance * 0.5, target_ + margin_ + radii_);
  if (is_beyond(found.lower - radii_)) {
    passed_over_ = true;
    return;
  }
  if (found.upper + margin_ < radii_) return meet(one, two);
  const double lower = (found.lower - radii_ - margin_) * kDown,
               upper = (found.upper - radii_ + margin_) * kUp;
  if (!(lower > 0 && upper - lower <= options_.tolerance * upper))
    return solve_precisely(one, two, triangle_[1]);
  if (upper < upper_) {
    const Vector3 way = found.point_2 - found.point_1;
    point_1_ = found.point_1 + way * (radius_1_ / found.upper);
    point_2_ = found.point_2 - way * ((radii_ - radius_1_) / found.upper);
    normal_ = found.normal;
    points_ = Points::in_first;
  }
  take(lower, upper, one, two);
}

void MeshSearch::look_at_body(std::int32_t one) {
  const TriangleCorners& a = first_->tree().triangle(one);
  if (has_plane_) {
    const double top =
        std::max({dot(plane_, a.corner[0]), dot(plane_, a.corner[1]), dot(plane_, a.corner[2])});
    if (is_beyond(plane_of_ - top - radius_1_)) {
      passed_over_ = true;
      return;
    }
  }
  solve_precisely(one, 0, *other_.body);
}

void MeshSearch::take(double lower, double upper, std::int32_t one, std::int32_t two) {
  lower_ = std::min(lower_, std::max(lower, 0.0));
  if (!(upper < upper_)) return;
  upper_ = upper;
  nearest_1_ = one;
  nearest_2_ = two;
  target_ = std::min(enough_, upper * (1 - options_.tolerance) * kUp);
}

// u proves a distance, and points from 1 to 2.
void MeshSearch::take_normal(const double* from_2_to_1, bool nearer) {
  const Vector3 u = -W_.transposed_times({from_2_to_1[0], from_2_to_1[1], from_2_to_1[2]});
  if (nearer) normal_ = u;
  if (other_.body == nullptr || other_.is_half_space) return;
  const Vector3 v = R_.transposed_times(u);
  const double down[3] = {-v.x, -v.y, -v.z};
  double lowest[3];
  plane_ = u;
  plane_of_ = dot(u, t_) - other_.body->support_unchecked(down, lowest);
  has_plane_ = true;
}

void MeshSearch::solve_precisely(std::int32_t one, std::int32_t two, const ConvexSet& second) {
  ++counters_.precise_pairs;
  triangle_[0].assign(*first_, one);
  if (other_.mesh != nullptr) triangle_[1].assign(*other_.mesh, two);
  if (!solve_.bind(triangle_[0], second, options_.instruction_set) ||
      !solve_.place(PoseNumbers(pose_1_), PoseNumbers(pose_2_)))
    return solve_generally(one, two, second);
  const bool done = solve_.distance(options_.tolerance, nullptr);
  const SpatialAnswer& answer = solve_.answer();
  if (answer.end == SpatialEnd::intersecting) return meet(one, two);
  const bool nearer = answer.bounds.upper() < upper_;
  if (answer.bounds.lower() > 0) take_normal(solve_.normal(), nearer);
  if (nearer) {
    points_ = done ? Points::in_world : Points::unknown;
    if (done) solve_.closest_points(world_point_[0], world_point_[1]);
  }
  take(answer.bounds.lower(), answer.bounds.upper(), one, two);
}

void MeshSearch::solve_generally(std::int32_t one, std::int32_t two, const ConvexSet& second) {
  const ObjectDistance& answer = general_.solve(posed(triangle_[0], pose_1_), posed(second, pose_2_), ball_,
                                                ObjectEffects::closest_points);
  if (answer.distance.status == DistanceStatus::contains_origin) return meet(one, two);
  const bool nearer = answer.distance.upper < upper_;
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

void MeshSearch::meet(std::int32_t one, std::int32_t two) {
  meets_ = true;
  nearest_1_ = one;
  nearest_2_ = two;
}

}  // namespace raygauge
