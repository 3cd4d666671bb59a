// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace raygauge::scene_page {
namespace {

const std::string& body(const SceneFile& file, std::int32_t number) {
  return file.bodies.at(static_cast<std::size_t>(number)).name;
}

std::string both(const SceneFile& file, const SceneEvent& event) { return pair_name(file, event.a, event.b); }

/// The answers at instants to one query for one pair, in order of time.
using Track = std::vector<const SceneRecord*>;

bool has_distance(const SceneRecord& record) { return !std::isnan(record.distance); }
double value_of(const SceneRecord& r) { return has_distance(r) ? r.signed_distance() : r.growth; }

/// How deep, proven, and when.
std::string depth_words(const SceneFile& file, const SceneRecord& record) {
  return "at least " + event_bound(record.depth_lower) + length_unit(file, record.query) +
         " deep at the instant " + event_number(record.time) + " s";
}

/// How deep the two overlap at most, of instants; "" where nothing is known of that.
std::string deepest_overlap(const SceneFile& file, std::int32_t a, std::int32_t b) {
  const SceneRecord* deepest = nullptr;
  for (const SceneRow& row : file.records) {
    const SceneRecord& r = row.record;
    if (r.body_a != a || r.body_b != b || !(r.depth_lower > 0)) continue;
    if (deepest == nullptr || r.depth_lower > deepest->depth_lower) deepest = &r;
  }
  return deepest == nullptr ? "" : ", " + depth_words(file, *deepest);
}

/// The least distance or growth over the instants, or that there was no contact at them.
void add_least(const SceneFile& file, const Track& track, std::vector<SceneEvent>& events) {
  const SceneRecord &first = *track.front(), *least = nullptr;
  bool apart = true;
  for (const SceneRecord* record : track) {
    apart = apart && record->status == SceneStatus::separated;
    const double value = value_of(*record);
    if (!std::isnan(value) && (least == nullptr || value < value_of(*least))) least = record;
  }
  if (least == nullptr) {
    if (!apart) return;
    events.push_back({EventKind::free, first.query, first.body_a, first.body_b, false, SceneRecord::kNone,
                      SceneRecord::kNone, "apart at each of " + std::to_string(track.size()) + " instants"});
    return;
  }
  const bool distance = has_distance(*least);
  const std::string unit = distance ? length_unit(file, least->query) : "";
  if (least->depth_lower > 0) {
    events.push_back({EventKind::near, first.query, first.body_a, first.body_b, false, least->time,
                      least->signed_lower(), "overlap: " + depth_words(file, *least)});
    return;
  }
  events.push_back({EventKind::near, first.query, first.body_a, first.body_b, false, least->time,
                    distance ? least->lower : least->growth_lower,
                    (distance ? "least distance " : "least growth ") + event_number(value_of(*least)) + unit +
                        " at the instant " + event_number(least->time) + " s"});
}

bool more_dangerous(const SceneEvent& x, const SceneEvent& y) {
  if (x.kind != y.kind) return x.kind < y.kind;
  const bool by_value = x.kind == EventKind::near;
  const double p = by_value ? x.value : x.time, q = by_value ? y.value : y.time;
  return !std::isnan(p) && (std::isnan(q) || p < q);
}

std::string more_pairs(std::size_t count) {
  if (count < 2) return "";
  return "; " + std::to_string(count - 1) + (count == 2 ? " other pair meets" : " other pairs meet");
}

/// The first of the kind, of the whole time where `continuous`; null where there is none.
const SceneEvent* first_of(const std::vector<SceneEvent>& events, EventKind kind, bool continuous = false) {
  const auto found = std::find_if(events.begin(), events.end(), [&](const SceneEvent& event) {
    return event.kind == kind && (event.continuous || !continuous);
  });
  return found == events.end() ? nullptr : &*found;
}

/// Of a scene of one instant, as of grasps: the least and the largest answer.
std::string range_of_answers(const SceneFile& file) {
  const SceneRecord *least = nullptr, *most = nullptr;
  for (const SceneRow& row : file.records) {
    const double value = value_of(row.record);
    if (std::isnan(value)) continue;
    if (least == nullptr || value < value_of(*least)) least = &row.record;
    if (most == nullptr || value > value_of(*most)) most = &row.record;
  }
  if (least == nullptr) return "";
  const auto words = [&](const SceneRecord& r) {
    return event_number(value_of(r)) + (has_distance(r) ? length_unit(file, r.query) : "") + " (" +
           file.queries.at(static_cast<std::size_t>(r.query)).name + ")";
  };
  const std::string head = is_grasp(file) ? "contact forces that the task needs: " : "answers: ";
  return head + words(*least) + (least == most ? "" : " to " + words(*most));
}

Verdict without_contact(const SceneFile& file, const std::vector<SceneEvent>& events) {
  if (const SceneEvent* open = first_of(events, EventKind::undecided))
    return {"open", "not decided: " + both(file, *open) + ": " + open->text};
  if (const SceneEvent* least = first_of(events, EventKind::near, true))
    return {"safe", "safe: never closer than " + event_bound(least->value) + length_unit(file, least->query) +
                        " to anything asked (" + both(file, *least) + ")"};
  if (first_of(events, EventKind::free, true)) return {"safe", "safe: no contact at any time, proven"};
  const bool moves = std::any_of(file.records.begin(), file.records.end(),
                                 [](const SceneRow& row) { return row.record.instant > 0; });
  if (!moves) return {"open", range_of_answers(file)};
  const SceneEvent* least = first_of(events, EventKind::near);
  return {"open", "apart at every instant asked" +
                      (least == nullptr ? "" : "; " + both(file, *least) + ": " + least->text) +
                      "; between the instants nothing was asked"};
}

}  // namespace

bool is_grasp(const SceneFile& file) {
  return file.drawing.empty() && file.text.find("contact_wrenches") != std::string::npos;
}

std::vector<SceneEvent> events_of(const SceneFile& file) {
  std::vector<SceneEvent> events = changes_of(file);
  std::map<std::tuple<int, int, int>, Track> tracks;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (record.at_instant()) tracks[{record.query, record.body_a, record.body_b}].push_back(&record);
  }
  for (const auto& [key, track] : tracks) add_least(file, track, events);
  std::stable_sort(events.begin(), events.end(), more_dangerous);
  return events;
}

Verdict verdict_of(const SceneFile& file) {
  if (file.records.empty())
    return {"open", file.finished() ? "no pair was asked about" : "nothing is known yet"};
  const std::vector<SceneEvent> events = events_of(file);
  if (!events.empty() && events.front().kind == EventKind::contact) {
    const SceneEvent& first = events.front();
    std::set<std::pair<std::int32_t, std::int32_t>> pairs;
    for (const SceneEvent& event : events)
      if (event.kind == EventKind::contact) pairs.emplace(event.a, event.b);
    return {"unsafe", "not safe: " + body(file, first.a) + " meets " + body(file, first.b) + " at " +
                          event_number(first.time) + " s" + deepest_overlap(file, first.a, first.b) +
                          more_pairs(pairs.size())};
  }
  Verdict verdict = without_contact(file, events);
  if (file.finished()) return verdict;
  return {"open", "not finished (" + std::to_string(file.cells.size()) + " of " +
                      std::to_string(file.cell_count) + " cells); so far " + verdict.text};
}

}  // namespace raygauge::scene_page
