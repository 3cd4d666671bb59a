// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/mesh_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/meshes/point_inside.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kApart = std::numeric_limits<double>::min();

// Farther than this from a surface, in margins, a computed point is on the same side as the point itself.
constexpr double kClearMargins = 4;

// use(p) for a point of each connected part.
template <class Use>
void for_each_part(const Mesh& mesh, const Use& use) {
  for (const Eigen::Vector3d& p : mesh.part_points()) use(Vector3{p[0], p[1], p[2]});
  for (std::int32_t i = 0; mesh.kind() == MeshKind::cloud && i < mesh.size(); ++i)
    use(mesh.tree().triangle(i).corner[0]);
}

}  // namespace

MeshSearch::MeshSearch(const DistanceOptions& options)
    : options_(options),
      nearest_(options, watch_),
      boxes_(watch_),
      wide_(kernels_for(options.instruction_set), watch_) {}

void MeshSearch::search(const MeshPair& pair, double enough, MeshWarmStart* warm) {
  watch_.start(options_.time_limit, &stop_);
  pair_ = pair;
  nearest_.begin(pair_, std::max(enough, 2 * kClearMargins * pair_.margin));
  if (!pair_.in_range) {
    nearest_.found.lower = 0;
    return;
  }
  look_around(warm);
  if (pair_.mesh_2 != nullptr && pair_.in_single_range) {
    wide_.search(pair_, nearest_);
  } else {
    boxes_.search(pair_, nearest_);
  }
  nearest_.end_search();
  if (!nearest_.found.meets) locate();
}

// The nearest triangles of the last solve.
void MeshSearch::look_around(const MeshWarmStart* warm) {
  if (warm == nullptr || warm->triangle_1 < 0 || warm->triangle_1 >= pair_.first->size()) return;
  if (pair_.mesh_2 == nullptr) {
    if (warm->triangle_2 == 0) nearest_.look_at_body(warm->triangle_1);
  } else if (warm->triangle_2 >= 0 && warm->triangle_2 < pair_.mesh_2->size()) {
    nearest_.look_at(warm->triangle_1, warm->triangle_2, pair_.turned(warm->triangle_2));
  }
}

// Surfaces that are apart: one object may be inside the other.
void MeshSearch::locate() {
  NearestTriangles::Found& found = nearest_.found;
  const bool first = pair_.first->kind() == MeshKind::solid,
             second = pair_.mesh_2 != nullptr && pair_.mesh_2->kind() == MeshKind::solid;
  if ((!first && !second) || !(found.lower > 0) || pair_.half_space_2 != nullptr) return;
  if (!(found.lower >= kClearMargins * pair_.margin)) {
    found.lower = 0;
    return;
  }
  if (first) ask_points_of_second();
  if (second) ask_points_of_first();
}

void MeshSearch::ask_points_of_second() {
  if (pair_.mesh_2 == nullptr) {
    double c[3];
    pair_.body_2->center_unchecked(c);
    return ask(*pair_.first, pair_.to_first({c[0], c[1], c[2]}));
  }
  for_each_part(*pair_.mesh_2, [&](const Vector3& p) { ask(*pair_.first, pair_.to_first(p)); });
}

void MeshSearch::ask_points_of_first() {
  for_each_part(*pair_.first,
                [&](const Vector3& p) { ask(*pair_.mesh_2, pair_.R.transposed_times(p - pair_.t)); });
}

void MeshSearch::ask(const Mesh& solid, const Vector3& point) {
  NearestTriangles::Found& found = nearest_.found;
  if (found.meets) return;
  ++nearest_.counters.points_located;
  const Inside inside = point_inside(solid.tree(), point);
  if (inside == Inside::yes) {
    found.meets = true;
    found.inside_by = found.lower;
  }
  if (inside == Inside::unknown) found.lower = 0;
}

void MeshSearch::keep_nearest(MeshWarmStart* warm) const {
  if (warm == nullptr || nearest_.found.nearest_1 < 0) return;
  warm->triangle_1 = nearest_.found.nearest_1;
  warm->triangle_2 = nearest_.found.nearest_2;
}

Separation MeshSearch::separation(const MeshPair& pair, MeshWarmStart* warm) {
  search(pair, kApart, warm);
  keep_nearest(warm);
  const NearestTriangles::Found& found = nearest_.found;
  if (found.meets) return Separation::intersecting;
  return std::min(found.lower, found.upper) > 0 ? Separation::separated : Separation::undecided;
}

const ObjectDistance& MeshSearch::distance(const MeshPair& pair, ObjectEffects effects, MeshWarmStart* warm) {
  search(pair, kInfinity, warm);
  write_bounds();
  write_points(effects);
  keep_nearest(warm);
  return result_;
}

void MeshSearch::write_bounds() {
  NearestTriangles::Found& found = nearest_.found;
  DistanceResult& distance = result_.distance;
  if (found.meets) found.lower = found.upper = 0;
  distance.upper = found.upper;
  distance.lower = std::min(found.lower, found.upper);
  distance.distance = distance.upper;
  distance.counters = {};
  distance.counters.support_queries = nearest_.counters.precise_pairs;
  distance.seconds = watch_.seconds();
  const bool closed =
      found.upper < kInfinity && distance.upper - distance.lower <= options_.tolerance * distance.upper;
  distance.status = found.meets         ? DistanceStatus::contains_origin
                    : closed            ? DistanceStatus::optimal
                    : found.out_of_time ? DistanceStatus::time_limit
                                        : DistanceStatus::precision_limit;
  const bool has_normal = distance.lower > 0 && dot(found.normal, found.normal) > 0;
  distance.normal.resize(has_normal ? 3 : 0);
  if (!has_normal) return;
  const Vector3 n = pair_.W * -found.normal;
  distance.normal << n.x, n.y, n.z;
}

void MeshSearch::write_points(ObjectEffects effects) {
  const bool apart = result_.distance.lower > 0 && nearest_.found.upper < kInfinity;
  double point[2][3];
  const bool points =
      apart && has_effect(effects, ObjectEffects::closest_points) && nearest_.closest_points(point);
  result_.closest_point_evaluations = points ? 1 : 0;
  result_.closest_point_1.resize(points ? 3 : 0);
  result_.closest_point_2.resize(points ? 3 : 0);
  if (points) {
    result_.closest_point_1 = Eigen::Vector3d::Map(point[0]);
    result_.closest_point_2 = Eigen::Vector3d::Map(point[1]);
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
  const NearestTriangles::Found& found = nearest_.found;
  if (!found.meets || !(way < kInfinity) || way == 0) return found.meets && way == 0;
  if (found.inside_by > 0) return found.inside_by > way;
  const Pose where = pair_.pose_2 == nullptr ? Pose(3) : *pair_.pose_2;
  Pose moved(3);
  for (int k = 0; k < 6; ++k) {
    double t[3];
    std::copy_n(where.translation_data(), 3, t);
    const double side = k % 2 == 0 ? 1 : -1;
    t[k / 2] = std::nextafter(t[k / 2] + side * kCorner * way, side * kInfinity);
    moved.assign_checked(where.rotation_data(), t, where.defect());
    if (!nearest_.nearest_meet(moved)) return false;
  }
  return true;
}

}  // namespace raygauge
