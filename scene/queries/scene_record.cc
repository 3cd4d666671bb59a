// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_run.h"

#include <algorithm>
#include <array>

#include "raygauge/exceptions.h"

namespace raygauge {

namespace {

constexpr std::array<std::string_view, 4> kDecisions = {"solved", "broad_phase", "coherence", "static"};
constexpr std::array<std::string_view, 5> kStatuses = {"separated", "intersecting", "undecided", "contact",
                                                       "free"};
constexpr const char* kInstant = "instant";

template <class Enum, std::size_t count>
Enum from_text(const std::array<std::string_view, count>& words, const std::string& text, const char* what) {
  const auto* const found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) throw UnknownNameError(what, text, {words.begin(), words.end()});
  return static_cast<Enum>(found - words.begin());
}

}  // namespace

std::string_view to_string(SceneDecision decision) noexcept {
  return kDecisions.at(static_cast<std::size_t>(decision));
}

std::string_view to_string(SceneStatus status) noexcept {
  return kStatuses.at(static_cast<std::size_t>(status));
}

SceneStatus status_from(const std::string& text) { return from_text<SceneStatus>(kStatuses, text, "status"); }

SceneDecision decision_from(const std::string& text) {
  return from_text<SceneDecision>(kDecisions, text, "decision");
}

std::string kind_text(SceneEffects kind) { return kind == SceneEffects::none ? kInstant : to_string(kind); }

SceneEffects kind_from(const std::string& text) {
  return text == kInstant ? SceneEffects::none : effect_named(text);
}

// clang-format off
std::span<const SceneField> scene_fields() noexcept {
  using R = SceneRecord;
  static const std::array kFields = {
    SceneField{&R::query, "query", "1", "row of /queries"},
    SceneField{&R::body_a, "body_a", "1", "row of /bodies; the first of the pair"},
    SceneField{&R::body_b, "body_b", "1", "row of /bodies; the second of the pair"},
    SceneField{&R::part_a, "part_a", "1", "nearest convex part of body_a; -1: not looked for"},
    SceneField{&R::part_b, "part_b", "1", "nearest convex part of body_b; -1: not looked for"},
    SceneField{&R::kind, "kind", "", "instant, time_of_impact or clearance"},
    SceneField{&R::instant, "instant", "1", "number of the instant, from 0; -1: of the whole time"},
    SceneField{&R::time, "time", "s", "time of the instant; of the contact; at which the clearance is attained"},
    SceneField{&R::time_lower, "time_lower", "s", "proven that there is no contact before it: of a time of impact, and of the clearance of bodies that meet"},
    SceneField{&R::time_upper, "time_upper", "s", "proven that there is a contact at it, of the same; nan: there is none"},
    SceneField{&R::status, "status", "", "separated, intersecting, undecided; of a time of impact contact, free, undecided"},
    SceneField{&R::decided, "decided", "", "by what: solved, broad_phase, coherence, static"},
    SceneField{&R::distance, "distance", "1", "distance in the metric of the query; nan: not asked for"},
    SceneField{&R::lower, "lower", "1", "certified lower bound of the distance"},
    SceneField{&R::upper, "upper", "1", "certified upper bound of the distance"},
    SceneField{&R::growth, "growth", "1", "growth distance about the centres; below 1: the bodies overlap; nan: not asked for"},
    SceneField{&R::growth_lower, "growth_lower", "1", "certified lower bound of the growth distance"},
    SceneField{&R::growth_upper, "growth_upper", "1", "certified upper bound of the growth distance"},
    SceneField{&R::depth, "depth", "1", "how deep the bodies overlap, in the metric of the query; 0: they are apart; nan: not asked for", true},
    SceneField{&R::depth_lower, "depth_lower", "1", "certified lower bound of the depth", true},
    SceneField{&R::depth_upper, "depth_upper", "1", "certified upper bound of the depth", true},
    SceneField{&R::solves, "solves", "1", "pairs of convex parts solved for the row"},
    SceneField{&R::seconds, "seconds", "s", "wall time of those solves"},
    SceneField{&R::point_a, "point_a", "1", "closest point of body_a, or with a depth its point in contact, one coordinate; nan: not asked for"},
    SceneField{&R::point_b, "point_b", "1", "closest point of body_b, or with a depth its point in contact, one coordinate; nan: not asked for"},
    SceneField{&R::gradient, "gradient", "1", "gradient of the distance as body_a is translated, or with a depth its way out, one coordinate; nan: not asked for"},
  };
  return kFields;
}
// clang-format on

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
  depths += other.depths;
  closest_points += other.closest_points;
  gradients += other.gradients;
  plane_tests += other.plane_tests;
  ball_tests += other.ball_tests;
  support_queries += other.support_queries;
  return *this;
}

}  // namespace raygauge
