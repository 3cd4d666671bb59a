// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What a MeshSearch makes of the nearest triangles: whether one object is inside the other, and the answer.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/meshes/point_inside.h"
#include "engine/numerics/floating_point.h"
#include "engine/queries/mesh_search.h"

namespace raygauge {
namespace {

// use(p) for a point of each connected part.
template <class Use>
void for_each_part(const Mesh& mesh, const Use& use) {
  for (const Eigen::Vector3d& p : mesh.part_points()) use(Vector3{p[0], p[1], p[2]});
  for (std::int32_t i = 0; mesh.kind() == MeshKind::cloud && i < mesh.size(); ++i)
    use(mesh.tree().triangle(i).corner[0]);
}

}  // namespace

// Surfaces that are apart: one object may be inside the other.
void MeshSearch::locate() {
  const bool first = first_->kind() == MeshKind::solid,
             second = other_.mesh != nullptr && other_.mesh->kind() == MeshKind::solid;
  if ((!first && !second) || !(lower_ > 0) || other_.is_half_space) return;
  if (!(lower_ >= kClearMargins * margin_)) {
    lower_ = 0;
    return;
  }
  if (first) ask_points_of_second();
  if (second) ask_points_of_first();
}

void MeshSearch::ask_points_of_second() {
  if (other_.mesh == nullptr) {
    double c[3];
    other_.body->center_unchecked(c);
    return ask(*first_, to_first({c[0], c[1], c[2]}));
  }
  for_each_part(*other_.mesh, [&](const Vector3& p) { ask(*first_, to_first(p)); });
}

void MeshSearch::ask_points_of_first() {
  for_each_part(*first_, [&](const Vector3& p) { ask(*other_.mesh, R_.transposed_times(p - t_)); });
}

void MeshSearch::ask(const Mesh& solid, const Vector3& point) {
  if (meets_) return;
  ++counters_.points_located;
  const Inside inside = point_inside(solid.tree(), point);
  if (inside == Inside::yes) {
    meets_ = true;
    inside_by_ = lower_;
  }
  if (inside == Inside::unknown) lower_ = 0;
}

void MeshSearch::keep_nearest(MeshWarmStart* warm) const {
  if (warm == nullptr || nearest_1_ < 0) return;
  warm->triangle_1 = nearest_1_;
  warm->triangle_2 = nearest_2_;
}

Separation MeshSearch::separation_found(MeshWarmStart* warm) const {
  keep_nearest(warm);
  if (meets_) return Separation::intersecting;
  return std::min(lower_, upper_) > 0 ? Separation::separated : Separation::undecided;
}

const ObjectDistance& MeshSearch::finish(ObjectEffects effects, MeshWarmStart* warm) {
  DistanceResult& distance = result_.distance;
  if (meets_) lower_ = upper_ = 0;
  distance.upper = upper_;
  distance.lower = std::min(lower_, upper_);
  distance.distance = distance.upper;
  distance.counters = {};
  distance.counters.support_queries = counters_.precise_pairs;
  distance.seconds = watch_.seconds();
  const bool closed =
      upper_ < kInfinity && distance.upper - distance.lower <= options_.tolerance * distance.upper;
  distance.status = meets_         ? DistanceStatus::contains_origin
                    : closed       ? DistanceStatus::optimal
                    : out_of_time_ ? DistanceStatus::time_limit
                                   : DistanceStatus::precision_limit;
  const bool has_normal = distance.lower > 0 && dot(normal_, normal_) > 0;
  distance.normal.resize(has_normal ? 3 : 0);
  if (has_normal) {
    const Vector3 n = W_ * -normal_;
    distance.normal << n.x, n.y, n.z;
  }
  write_points(effects);
  keep_nearest(warm);
  return result_;
}

void MeshSearch::write_points(ObjectEffects effects) {
  const bool apart = result_.distance.lower > 0 && upper_ < kInfinity;
  const bool points =
      apart && points_ != Points::unknown && has_effect(effects, ObjectEffects::closest_points);
  result_.closest_point_evaluations = points ? 1 : 0;
  result_.closest_point_1.resize(points ? 3 : 0);
  result_.closest_point_2.resize(points ? 3 : 0);
  for (int i = 0; i < 2 && points; ++i) {
    if (points_ == Points::in_first) {
      const Vector3 x = W_ * (i == 0 ? point_1_ : point_2_) + w_;
      world_point_[i][0] = x.x;
      world_point_[i][1] = x.y;
      world_point_[i][2] = x.z;
    }
    (i == 0 ? result_.closest_point_1 : result_.closest_point_2) = Eigen::Vector3d::Map(world_point_[i]);
  }
  const bool gradient =
      apart && result_.distance.normal.size() == 3 && has_effect(effects, ObjectEffects::gradient);
  result_.gradient_evaluations = gradient ? 1 : 0;
  result_.gradient_1.resize(gradient ? 3 : 0);
  result_.gradient_2.resize(gradient ? 3 : 0);
  if (!gradient) return;
  result_.gradient_1 = result_.distance.normal;
  result_.gradient_2 = -result_.distance.normal;
}

const ObjectDistance& MeshSearch::turn_answer() noexcept {
  std::swap(result_.closest_point_1, result_.closest_point_2);
  std::swap(result_.gradient_1, result_.gradient_2);
  result_.distance.normal = -result_.distance.normal;
  return result_;
}

// The translations that leave two convex sets with a common point are a convex set. Where it holds the six
// corners of an octahedron it holds the ball inside, whose radius is 1/√3 of theirs.
bool MeshSearch::meets_if_moved(double way) {
  constexpr double kCorner = 2;
  if (!meets_ || !(way < kInfinity) || way == 0) return meets_ && way == 0;
  if (inside_by_ > 0) return inside_by_ > way;
  if (other_.mesh != nullptr) triangle_[1].assign(*other_.mesh, nearest_2_);
  const ConvexSet& second = other_.tree != nullptr ? triangle_[1] : *other_.body;
  triangle_[0].assign(*first_, nearest_1_);
  const Posed one = posed(triangle_[0], pose_1_);
  const Pose where = pose_2_ == nullptr ? Pose(3) : *pose_2_;
  Pose moved(3);
  for (int k = 0; k < 6; ++k) {
    double t[3];
    std::copy_n(where.translation_data(), 3, t);
    const double side = k % 2 == 0 ? 1 : -1;
    t[k / 2] = std::nextafter(t[k / 2] + side * kCorner * way, side * kInfinity);
    moved.assign_checked(where.rotation_data(), t, where.defect());
    const ObjectDistance& there = general_.solve(one, {second, moved}, ball_);
    if (there.distance.status != DistanceStatus::contains_origin) return false;
  }
  return true;
}

}  // namespace raygauge
