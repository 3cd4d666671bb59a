// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What an EdgeSearch asks of two parts at one time, and of meshes over an interval.
#include <algorithm>

#include "engine/meshes/triangle_set.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/pose.h"
#include "scene/planning/edge_search.h"

namespace raygauge {
namespace {

const Mesh* mesh_of(const EdgeShape& shape) { return as_mesh(*shape.part->set); }

bool is_solid(const Mesh* mesh) { return mesh != nullptr && mesh->kind() == MeshKind::solid; }

// The triangle or the ball of a mesh, or the convex set itself.
const ConvexSet& piece_of(const ConvexSet& set, std::int32_t number, TriangleSet& piece) {
  const Mesh* mesh = as_mesh(set);
  if (mesh == nullptr) return set;
  piece.assign(*mesh, number);
  return piece;
}

}  // namespace

void EdgeSearch::take_kind(Parts& parts) const {
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const Mesh* a = mesh_of(bodies_[static_cast<std::size_t>(pair.a)].shapes[parts.shape_a]);
  const Mesh* b = mesh_of(bodies_[static_cast<std::size_t>(pair.b)].shapes[parts.shape_b]);
  parts.is_mesh = a != nullptr || b != nullptr;
  parts.is_solid = is_solid(a) || is_solid(b);
}

// Surfaces that stay apart are one inside the other all the time or at no time.
bool EdgeSearch::is_free_by_sweep(Parts& parts, int interval) {
  const Interval over = intervals_[static_cast<std::size_t>(interval)];
  if (!surfaces_apart(parts, interval)) return false;
  if (!parts.is_solid) return true;
  place(parts, over.first);
  return solver_.separation(placed_, numbers_of(parts), parts.memory, counters_) == Separation::separated;
}

bool EdgeSearch::surfaces_apart(const Parts& parts, int interval) {
  const int middle = middle_of(static_cast<std::size_t>(interval));
  const Interval over = intervals_[static_cast<std::size_t>(interval)];
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const Sagging sagging = tests_.sagging(pair, parts.shape_a, parts.shape_b, over.first, over.last);
  SweepMoments moments;
  const int moment[3] = {over.first, middle, over.last};
  double loss = 0;
  for (int k = 0; k < 3; ++k) {
    tests_.stand(pair, moment[k], moments.R_a[k], moments.R_b[k], moments.way[k]);
    loss = std::max(loss, tests_.loss(pair, parts.shape_a, parts.shape_b, moment[k]));
  }
  ++result_.plane_tests;
  sweep_.bind(bodies_[static_cast<std::size_t>(pair.a)].shapes[parts.shape_a],
              bodies_[static_cast<std::size_t>(pair.b)].shapes[parts.shape_b]);
  return sweep_.apart(moments, sagging, options_.margin + loss, parts.memory.mesh);
}

// Both halves of an interval in whose middle they are apart, if that is known.
void EdgeSearch::go_on_with_mesh(const Item& item, bool known) {
  Parts& parts = parts_[static_cast<std::size_t>(item.parts)];
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const double now = answer_.lower;
  for (const bool is_left : {true, false}) {
    const int half = half_of(static_cast<std::size_t>(item.interval), is_left);
    const Interval over = intervals_[static_cast<std::size_t>(half)];
    ++result_.ball_tests;
    if (tests_.balls_apart(pair, parts.shape_a, parts.shape_b, over.first, over.last, options_.margin))
      continue;
    if (known && surfaces_apart(parts, half)) continue;
    add_item({item.parts, half, now});
  }
}

PartNumbers EdgeSearch::numbers_of(const Parts& parts) {
  return {static_cast<int>(parts.shape_a) - 1, static_cast<int>(parts.shape_b) - 1};
}

void EdgeSearch::place(const Parts& parts, int moment) {
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const EdgeBody& a = bodies_[static_cast<std::size_t>(pair.a)];
  const EdgeBody& b = bodies_[static_cast<std::size_t>(pair.b)];
  stage_.place(moment, a, b, placed_);
}

void EdgeSearch::look(Parts& parts, int moment) {
  place(parts, moment);
  answer_ = PairAnswer();
  parts.memory.overlapped =
      false;  // which would ask first whether they still do: slower for two parts of R^3
  const PartNumbers numbers = numbers_of(parts);
  solver_.distance(placed_, numbers, false, parts.memory, answer_, counters_);
  answer_.part_a = numbers.a;
  answer_.part_b = numbers.b;
  ++result_.looks;
}

bool EdgeSearch::is_contact(Parts& parts, int moment) {
  look(parts, moment);
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const double slack = tests_.slack(pair, parts.shape_a, parts.shape_b, moment);
  if (!(answer_.upper + slack <= options_.margin + options_.contact)) return false;
  result_.outcome = EdgeOutcome::contact;
  result_.time = stage_.time(moment);
  result_.body_a = pair.a;
  result_.body_b = pair.b;
  result_.part_a = answer_.part_a;
  result_.part_b = answer_.part_b;
  result_.lower = std::max(0.0, answer_.lower - slack);
  result_.upper = answer_.upper + slack;
  if (options_.witness) take_witness(parts);
  return true;
}

// As they are placed for the last look.
void EdgeSearch::take_witness(const Parts& parts) {
  if (parts.is_mesh) return take_mesh_witness(parts);
  const PartNumbers numbers = numbers_of(parts);
  const ObjectDistance& found =
      witness_.solve(placed_.posed_a(numbers), placed_.posed_b(numbers), placed_.unit_ball(),
                     ObjectEffects::closest_points | ObjectEffects::depth);
  const bool overlap = found.depth.evaluations > 0 && found.depth.depth > 0;
  result_.point_a = overlap ? found.depth.point_1 : found.closest_point_1;
  result_.point_b = overlap ? found.depth.point_2 : found.closest_point_2;
  result_.depth = overlap ? found.depth.depth : 0;
}

// Of the nearest pieces; where these overlap the depth of the whole is not known.
void EdgeSearch::take_mesh_witness(const Parts& parts) {
  const PartNumbers numbers = numbers_of(parts);
  const MeshWarmStart& nearest = parts.memory.mesh;
  TriangleSet own[2];
  const Posed a = placed_.posed_a(numbers), b = placed_.posed_b(numbers);
  const ObjectDistance& found =
      witness_.solve({piece_of(a.set, nearest.triangle_1, own[0]), *a.pose},
                     {piece_of(b.set, nearest.triangle_2, own[1]), *b.pose}, placed_.unit_ball(),
                     ObjectEffects::closest_points | ObjectEffects::depth);
  const bool overlap = found.depth.evaluations > 0 && found.depth.depth > 0;
  result_.point_a = overlap ? found.depth.point_1 : found.closest_point_1;
  result_.point_b = overlap ? found.depth.point_2 : found.closest_point_2;
  if (answer_.upper > 0) result_.depth = 0;
}

void EdgeSearch::give_up(const Parts& parts, int moment) {
  if (result_.outcome == EdgeOutcome::undecided) return;
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  result_.outcome = EdgeOutcome::undecided;
  result_.time = stage_.time(moment);
  result_.body_a = pair.a;
  result_.body_b = pair.b;
  result_.part_a = static_cast<int>(parts.shape_a) - 1;
  result_.part_b = static_cast<int>(parts.shape_b) - 1;
}

}  // namespace raygauge
