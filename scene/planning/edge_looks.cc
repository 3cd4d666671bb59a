// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_looks.h"

#include <algorithm>

#include "engine/meshes/triangle_set.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

// Distances of a gap that lets the search tell margin and margin + contact apart; more digits than a step
// needs are asked for only where the margin is large.
double tolerance_of(const EdgeOptions& options) {
  constexpr double kStepTolerance = 1e-3;
  return std::clamp(options.contact / (4 * (options.margin + options.contact)), 1e-9, kStepTolerance);
}

// The triangle or the ball of a mesh, or the convex set itself.
Posed piece_of(const Posed& whole, std::int32_t number, TriangleSet& piece) {
  const Mesh* mesh = as_mesh(whole.set);
  if (mesh == nullptr) return whole;
  piece.assign(*mesh, number);
  Posed posed(piece);
  posed.pose = whole.pose;
  return posed;
}

}  // namespace

EdgeLooks::EdgeLooks(const EdgeOptions& options, const std::vector<EdgeBody>& bodies, const EdgeStage& stage,
                     EdgeTests& tests, const EdgePairs& pairs, EdgeResult& result)
    : options_(options),
      bodies_(bodies),
      stage_(stage),
      tests_(tests),
      pairs_(pairs),
      result_(result),
      placed_(3) {
  solver_.set_tolerance(tolerance_of(options));
}

bool EdgeLooks::is_outside(EdgeParts& parts, int moment) {
  place(parts, moment);
  return solver_.separation(placed_, parts.numbers(), parts.memory, counters_) == Separation::separated;
}

bool EdgeLooks::surfaces_apart(const EdgeParts& parts, int first, int middle, int last) {
  const EdgePair& pair = pairs_.pair_of(parts);
  const Sagging sagging = tests_.sagging(pair, parts.shape_a, parts.shape_b, first, last);
  SweepMoments moments;
  const int moment[3] = {first, middle, last};
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

void EdgeLooks::place(const EdgeParts& parts, int moment) {
  const EdgePair& pair = pairs_.pair_of(parts);
  stage_.place(moment, bodies_[static_cast<std::size_t>(pair.a)], bodies_[static_cast<std::size_t>(pair.b)],
               placed_);
}

void EdgeLooks::look(EdgeParts& parts, int moment) {
  place(parts, moment);
  answer_ = PairAnswer();
  parts.memory.overlapped =
      false;  // which would ask first whether they still do: slower for two parts of R^3
  const PartNumbers numbers = parts.numbers();
  solver_.distance(placed_, numbers, false, parts.memory, answer_, counters_);
  answer_.part_a = numbers.a;
  answer_.part_b = numbers.b;
  ++result_.looks;
}

bool EdgeLooks::is_contact(EdgeParts& parts, int moment) {
  look(parts, moment);
  const EdgePair& pair = pairs_.pair_of(parts);
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

// As they are placed for the last look; of meshes the nearest pieces, and where these overlap the depth of
// the whole is not known.
void EdgeLooks::take_witness(const EdgeParts& parts) {
  const PartNumbers numbers = parts.numbers();
  const MeshWarmStart& nearest = parts.memory.mesh;
  TriangleSet own[2];
  const ObjectDistance& found =
      witness_.solve(piece_of(placed_.a().posed(numbers.a), nearest.triangle_1, own[0]),
                     piece_of(placed_.b().posed(numbers.b), nearest.triangle_2, own[1]), placed_.unit_ball(),
                     ObjectEffects::closest_points | ObjectEffects::depth);
  const bool overlap = found.depth.evaluations > 0 && found.depth.depth > 0;
  result_.point_a = overlap ? found.depth.point_1 : found.closest_point_1;
  result_.point_b = overlap ? found.depth.point_2 : found.closest_point_2;
  if (!parts.is_mesh) {
    result_.depth = overlap ? found.depth.depth : 0;
  } else if (answer_.upper > 0) {
    result_.depth = 0;
  }
}

void EdgeLooks::give_up(const EdgeParts& parts, int moment) {
  if (result_.outcome == EdgeOutcome::undecided) return;
  const EdgePair& pair = pairs_.pair_of(parts);
  result_.outcome = EdgeOutcome::undecided;
  result_.time = stage_.time(moment);
  result_.body_a = pair.a;
  result_.body_b = pair.b;
  result_.part_a = parts.numbers().a;
  result_.part_b = parts.numbers().b;
}

}  // namespace raygauge
