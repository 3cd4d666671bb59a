// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/events.h"

#include <map>
#include <tuple>

namespace raygauge {
namespace {

SceneEvent change_event(const SceneFile& file, const SceneRecord& record) {
  EventKind kind = EventKind::undecided;
  std::string word = "meet, or nearly: undecided";
  if (record.status == SceneStatus::intersecting) kind = EventKind::contact, word = "contact";
  if (record.status == SceneStatus::separated) kind = EventKind::release, word = "release";
  SceneEvent event = event_of_kind(kind, record, record.time);
  event.text =
      word + " at instant " + std::to_string(record.instant) + ", " + event_number(record.time) + " s";
  if (record.depth_lower > 0)
    event.text += ", at least " + event_bound(record.depth_lower) + length_unit(file, record.query) + " deep";
  return event;
}

}  // namespace

SceneEvent event_of(const SceneFile& file, const SceneRecord& record) {
  return entry_of(record.kind).event(record, length_unit(file, record.query));
}

std::vector<SceneEvent> changes_of(const SceneFile& file) {
  std::vector<SceneEvent> events;
  std::map<std::tuple<int, int, int>, SceneStatus> before;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (!record.at_instant()) {
      events.push_back(event_of(file, record));
      continue;
    }
    const auto [known, first] =
        before.try_emplace({record.query, record.body_a, record.body_b}, record.status);
    const bool changed = first ? record.status == SceneStatus::intersecting : known->second != record.status;
    if (changed) events.push_back(change_event(file, record));
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
