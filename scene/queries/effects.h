// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "raygauge/scene/continuous.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge {

class PairSolver;

/// What an answer says, in the order of danger.
enum class EventKind : std::uint8_t {
  contact,    ///< the bodies share a point, proven
  undecided,  ///< the bounds do not tell whether they do
  near,       ///< how near they come
  free,       ///< they never touch, or at no instant that was asked
  release,    ///< apart again after a contact
};

std::string_view to_string(EventKind kind) noexcept;

/// What an answer says, for people.
struct SceneEvent {
  EventKind kind = EventKind::free;
  std::int32_t query = 0, a = 0, b = 0;
  bool continuous = false;            ///< of all times, not of instants
  double time = SceneRecord::kNone;   ///< seconds; NaN: of the whole time
  double value = SceneRecord::kNone;  ///< of `near`: the lower bound of the distance, or of the growth
  std::string text;                   ///< without the names of the query and of the bodies
};

/// As of ContinuousSolver, by a solver that is bound anew.
ImpactResult time_of_impact(PairSolver& solver, const Body& a, const Body& b,
                            const ContinuousOptions& options);
ClearanceResult clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                          const Body* metric_body, const ContinuousOptions& options);

/// Two bodies of a scene over its whole time.
struct ContinuousQuestion {
  const Body& a;
  const Body& b;
  const SceneMetric& metric;
  const Body* metric_body;
  ContinuousOptions options;
};

/// What can be asked of two bodies: a line each in effects.cc.
struct Effect {
  SceneEffects effect;
  std::string_view name;

  /// How it is answered, one line for people; "": with the other effects at instants.
  std::string_view way = "";

  /// Of an effect over the whole time: fills the row, and says what a row says. `unit` follows distances.
  void (*answer)(const ContinuousQuestion& question, PairSolver& solver, SceneRecord& row) = nullptr;
  SceneEvent (*event)(const SceneRecord& row, const std::string& unit) = nullptr;
};

std::span<const Effect> all_effects() noexcept;

/// The line of one effect.
const Effect& entry_of(SceneEffects effect);

/// Those over the whole time.
Effect time_of_impact_effect() noexcept;
Effect clearance_effect() noexcept;

/// Numbers of events: with 6 digits; rounded down, as what is said to be a lower bound has to be one; and an
/// interval of time, which is narrower than 6 digits show.
std::string event_number(double x);
std::string event_bound(double x);
std::string event_interval(double from, double to);

/// The event of a record, to be filled in further.
SceneEvent event_of_kind(EventKind kind, const SceneRecord& record, double time);

}  // namespace raygauge
