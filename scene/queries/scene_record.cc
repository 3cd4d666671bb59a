// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_record.h"

namespace raygauge {

std::string_view to_string(SceneDecision decision) noexcept {
  switch (decision) {
    case SceneDecision::solved:
      return "solved";
    case SceneDecision::broad_phase:
      return "broad_phase";
    case SceneDecision::coherence:
      return "coherence";
    case SceneDecision::standing:
      return "static";
  }
  return "?";
}

std::string_view to_string(SceneRowKind kind) noexcept {
  switch (kind) {
    case SceneRowKind::instant:
      return "instant";
    case SceneRowKind::time_of_impact:
      return "time_of_impact";
    case SceneRowKind::clearance:
      return "clearance";
  }
  return "?";
}

std::string_view to_string(SceneStatus status) noexcept {
  switch (status) {
    case SceneStatus::separated:
      return "separated";
    case SceneStatus::intersecting:
      return "intersecting";
    case SceneStatus::undecided:
      return "undecided";
    case SceneStatus::contact:
      return "contact";
    case SceneStatus::free:
      return "free";
  }
  return "?";
}

void SceneTally::count(SceneDecision decision, std::int64_t times) noexcept {
  asked += times;
  switch (decision) {
    case SceneDecision::solved:
      solved += times;
      break;
    case SceneDecision::broad_phase:
      broad_phase += times;
      break;
    case SceneDecision::coherence:
      coherence += times;
      break;
    case SceneDecision::standing:
      standing += times;
      break;
  }
}

SceneTally& SceneTally::operator+=(const SceneTally& other) {
  asked += other.asked;
  solved += other.solved;
  broad_phase += other.broad_phase;
  coherence += other.coherence;
  standing += other.standing;
  shared += other.shared;
  return *this;
}

SceneCounters& SceneCounters::operator+=(const SceneCounters& other) {
  distance_solves += other.distance_solves;
  separation_solves += other.separation_solves;
  growth_solves += other.growth_solves;
  closest_points += other.closest_points;
  gradients += other.gradients;
  plane_tests += other.plane_tests;
  ball_tests += other.ball_tests;
  support_queries += other.support_queries;
  return *this;
}

}  // namespace raygauge
