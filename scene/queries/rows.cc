// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/rows.h"

#include <cmath>

namespace raygauge {

SceneRecord begin_row(const Scene& scene, int query, BodyPair pair, std::int64_t k) {
  SceneRecord row;
  row.query = query;
  row.body_a = pair.a;
  row.body_b = pair.b;
  row.instant = k;
  if (k >= 0) row.time = scene.instants[static_cast<std::size_t>(k)];
  return row;
}

SceneStatus status_of(const PairAnswer& answer) {
  if (answer.intersecting()) return SceneStatus::intersecting;
  return answer.lower > 0 ? SceneStatus::separated : SceneStatus::undecided;
}

void take_distance(const PairAnswer& answer, SceneRecord& row) {
  row.part_a = answer.part_a;
  row.part_b = answer.part_b;
  row.lower = answer.lower;
  row.upper = answer.upper;
  row.distance = answer.value;
}

void take_points(const PairAnswer& answer, SceneRecord& row) {
  row.part_a = answer.part_a;
  row.part_b = answer.part_b;
  row.point_a = answer.point_a;
  row.point_b = answer.point_b;
}

void take_growth(const PairAnswer& growth, SceneRecord& row) {
  row.growth = growth.value;
  row.growth_lower = growth.lower;
  row.growth_upper = growth.upper;
}

// Bodies that are proven to be apart have none.
void take_depth(const PairAnswer& answer, SceneRecord& row) {
  const bool apart = answer.lower > 0;
  row.depth = row.depth_upper = apart ? 0 : answer.depth_upper;
  row.depth_lower = apart ? 0 : answer.depth_lower;
}

void take_asked(const PairAnswer& answer, SceneEffects effects, SceneRecord& row) {
  take_distance(answer, row);
  const bool whole = has_effect(effects, SceneEffects::depth);
  const bool apart = std::isnan(answer.depth_upper);  // else points and gradient are those of the depth
  if (whole) take_depth(answer, row);
  if (whole || (apart && has_effect(effects, SceneEffects::closest_points))) take_points(answer, row);
  if (whole || (apart && has_effect(effects, SceneEffects::gradient))) row.gradient = answer.gradient;
}

}  // namespace raygauge
