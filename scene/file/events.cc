// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/events.h"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

constexpr int kDigits = 6;

/// An interval of time is narrower than other digits show.
std::string between(double from, double to) {
  constexpr int kDigitsOfTimes = 10;
  return "[" + rounded_text(from, kDigitsOfTimes) + ", " + rounded_text(to, kDigitsOfTimes) + "] s";
}

SceneEvent begun(EventKind kind, const SceneRecord& record, double time) {
  const bool continuous = record.kind != SceneRowKind::instant;
  return {kind, record.query, record.body_a, record.body_b, continuous, time, SceneRecord::kNone, ""};
}

SceneEvent clearance_event(const SceneRecord& record, const std::string& unit) {
  if (record.status == SceneStatus::intersecting) {
    SceneEvent event = begun(EventKind::contact, record, record.time);
    event.text = std::isnan(record.time_lower)
                     ? "they meet at " + event_number(record.time) + " s"
                     : "they meet, first in " + between(record.time_lower, record.time);
    return event;
  }
  const bool apart = record.lower > 0;
  SceneEvent event = begun(apart ? EventKind::near : EventKind::undecided, record, record.time);
  event.value = record.lower;
  event.text =
      (apart ? "never closer than " + event_bound(record.lower) + unit : "meet, or nearly: undecided") +
      "; " + event_number(record.upper) + unit + " at " + event_number(record.time) + " s";
  return event;
}

SceneEvent impact_event(const SceneRecord& record) {
  SceneEvent event = begun(EventKind::undecided, record, record.time_lower);
  if (record.status == SceneStatus::free) {
    event = begun(EventKind::free, record, SceneRecord::kNone);
    event.text = "no contact, proven";
  } else if (record.status == SceneStatus::contact) {
    event = begun(EventKind::contact, record, record.time_upper);
    event.text = "first contact in " + between(record.time_lower, record.time_upper);
  } else {
    event.text = "no contact before " + event_number(record.time_lower) + " s, proven; after that undecided";
  }
  return event;
}

SceneEvent change_event(const SceneRecord& record) {
  EventKind kind = EventKind::undecided;
  std::string word = "meet, or nearly: undecided";
  if (record.status == SceneStatus::intersecting) kind = EventKind::contact, word = "contact";
  if (record.status == SceneStatus::separated) kind = EventKind::release, word = "release";
  SceneEvent event = begun(kind, record, record.time);
  event.text =
      word + " at instant " + std::to_string(record.instant) + ", " + event_number(record.time) + " s";
  return event;
}

}  // namespace

std::string_view to_string(EventKind kind) noexcept {
  static constexpr std::array<std::string_view, 5> kWords = {"contact", "undecided", "near", "free",
                                                             "release"};
  return kWords.at(static_cast<std::size_t>(kind));
}

std::string event_number(double x) { return rounded_text(x, kDigits); }

std::string event_bound(double x) {
  const std::string nearest = event_number(x);
  const double rounded = std::stod(nearest);
  if (!(rounded > x) || !std::isfinite(x)) return nearest;
  return event_number(rounded - std::pow(10, std::floor(std::log10(std::abs(x))) - kDigits + 1));
}

SceneEvent event_of(const SceneRecord& record, const std::string& unit) {
  return record.kind == SceneRowKind::clearance ? clearance_event(record, unit) : impact_event(record);
}

std::vector<SceneEvent> changes_of(const SceneFile& file) {
  std::vector<SceneEvent> events;
  std::map<std::tuple<int, int, int>, SceneStatus> before;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (record.kind != SceneRowKind::instant) {
      events.push_back(event_of(record, length_unit(file, record.query)));
      continue;
    }
    const auto [known, first] =
        before.try_emplace({record.query, record.body_a, record.body_b}, record.status);
    const bool changed = first ? record.status == SceneStatus::intersecting : known->second != record.status;
    if (changed) events.push_back(change_event(record));
    known->second = record.status;
  }
  return events;
}

std::string pair_name(const SceneFile& file, std::int32_t a, std::int32_t b) {
  return file.bodies.at(static_cast<std::size_t>(a)).name + " – " +
         file.bodies.at(static_cast<std::size_t>(b)).name;
}

std::string length_unit(const SceneFile& file, std::int32_t query) {
  const bool lengths =
      !file.drawing.empty() && file.queries.at(static_cast<std::size_t>(query)).metric == "euclidean";
  return lengths ? " m" : "";
}

}  // namespace raygauge
