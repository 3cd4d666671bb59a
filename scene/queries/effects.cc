// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/effects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr int kDigits = 6;

}  // namespace

std::span<const Effect> all_effects() noexcept {
  static const std::array kEffects = {
      Effect{SceneEffects::separated, "separated"},
      Effect{SceneEffects::distance, "distance"},
      Effect{SceneEffects::closest_points, "closest_points"},
      Effect{SceneEffects::gradient, "gradient"},
      Effect{SceneEffects::depth, "depth",
             "depth: of pairs that are not proven to be apart, with the points in contact and the way out"},
      Effect{SceneEffects::growth, "growth"},
      time_of_impact_effect(),
      clearance_effect(),
  };
  return kEffects;
}

const Effect& entry_of(SceneEffects effect) {
  const std::span<const Effect> all = all_effects();
  return *std::find_if(all.begin(), all.end(), [&](const Effect& entry) { return entry.effect == effect; });
}

std::string to_string(SceneEffects effects) {
  std::string names;
  for (const Effect& entry : all_effects()) {
    if (has_effect(effects, entry.effect)) names += (names.empty() ? "" : " ") + std::string(entry.name);
  }
  return names;
}

SceneEffects effect_named(const std::string& name, const std::string& place) {
  std::vector<std::string> known;
  for (const Effect& entry : all_effects()) {
    if (entry.name == name) return entry.effect;
    known.emplace_back(entry.name);
  }
  throw UnknownNameError("effect", name, known, place);
}

std::string_view to_string(EventKind kind) noexcept {
  static constexpr std::array<std::string_view, 5> kWords = {"contact", "undecided", "near", "free",
                                                             "release"};
  return kWords.at(static_cast<std::size_t>(kind));
}

std::string event_number(double x) { return rounded_text(x, kDigits); }

std::string event_bound(double x) {
  std::string nearest = event_number(x);
  const double rounded = std::stod(nearest);
  if (!(rounded > x) || !std::isfinite(x)) return nearest;
  return event_number(rounded - std::pow(10, std::floor(std::log10(std::abs(x))) - kDigits + 1));
}

std::string event_interval(double from, double to) {
  constexpr int kDigitsOfTimes = 10;
  return "[" + rounded_text(from, kDigitsOfTimes) + ", " + rounded_text(to, kDigitsOfTimes) + "] s";
}

SceneEvent event_of_kind(EventKind kind, const SceneRecord& record, double time) {
  return {kind, record.query, record.body_a, record.body_b, !record.at_instant(), time, SceneRecord::kNone,
          ""};
}

}  // namespace raygauge
