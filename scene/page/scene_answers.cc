// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "engine/numerics/number_text.h"

namespace raygauge::scene_page {
namespace {

constexpr int kDigits = 5;

std::string digits(double x) { return rounded_text(x, kDigits); }

/// Rounded down: what is said to be a lower bound has to be one.
std::string digits_below(double x) {
  const double rounded = std::stod(digits(x));
  if (!(rounded > x) || !std::isfinite(x)) return digits(x);
  const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - kDigits + 1);
  return digits(rounded - unit);
}

const std::string& body(const SceneFile& file, std::int32_t number) {
  return file.bodies.at(static_cast<std::size_t>(number)).name;
}

std::string both(const SceneFile& file, const Event& event) {
  return body(file, event.a) + " – " + body(file, event.b);
}

Event event_at(EventKind kind, const SceneRecord& record, double time) {
  const bool continuous = record.kind != SceneRowKind::instant;
  return {kind, record.query, record.body_a, record.body_b, continuous, time, SceneRecord::kNone, ""};
}

Event clearance_event(const SceneFile& file, const SceneRecord& record) {
  const std::string &a = body(file, record.body_a), &b = body(file, record.body_b);
  const std::string unit = length_unit(file, record.query);
  if (record.status == SceneStatus::intersecting) {
    Event event = event_at(EventKind::contact, record, record.time);
    event.text = a + " meets " + b + " at " + digits(record.time) + " s: first contact in [" +
                 rounded_text(record.time_lower, 10) + ", " + rounded_text(record.time, 10) + "] s";
    return event;
  }
  const bool apart = record.lower > 0;
  Event event = event_at(apart ? EventKind::near : EventKind::undecided, record, record.time);
  event.value = record.lower;
  const std::string least = digits(record.upper) + unit + " at " + digits(record.time) + " s";
  event.text = apart ? a + " never closer to " + b + " than " + digits_below(record.lower) + unit +
                           ", proven; " + least
                     : a + " and " + b + " meet, or nearly: undecided; " + least;
  return event;
}

Event impact_event(const SceneFile& file, const SceneRecord& record) {
  const std::string &a = body(file, record.body_a), &b = body(file, record.body_b);
  if (record.status == SceneStatus::free) {
    Event event = event_at(EventKind::free, record, SceneRecord::kNone);
    event.text = a + " never meets " + b + ", proven";
    return event;
  }
  if (record.status == SceneStatus::contact) {
    Event event = event_at(EventKind::contact, record, record.time_upper);
    event.text = a + " meets " + b + " at " + digits(record.time_upper) +
                 " s: first contact, proven to be in [" + rounded_text(record.time_lower, 10) + ", " +
                 rounded_text(record.time_upper, 10) + "] s";
    return event;
  }
  Event event = event_at(EventKind::undecided, record, record.time_lower);
  event.text =
      a + " does not meet " + b + " before " + digits(record.time_lower) + " s, proven; after that undecided";
  return event;
}

/// The answers at instants to one query for one pair, in order of time.
using Track = std::vector<const SceneRecord*>;

bool has_distance(const SceneRecord& record) { return !std::isnan(record.distance); }
double value_of(const SceneRecord& r) { return has_distance(r) ? r.distance : r.growth; }

/// Where the bodies come into contact, or apart again.
void add_changes(const SceneFile& file, const Track& track, std::vector<Event>& events) {
  const SceneRecord* before = nullptr;
  for (const SceneRecord* record : track) {
    const bool touches = record->status == SceneStatus::intersecting;
    const bool changed = before == nullptr ? touches : before->status != record->status;
    if (changed) {
      EventKind kind = touches ? EventKind::contact : EventKind::release;
      if (record->status == SceneStatus::undecided) kind = EventKind::undecided;
      Event event = event_at(kind, *record, record->time);
      static constexpr std::array<const char*, 3> kWords = {
          " in contact at the instant ", " apart at the instant ", " touch or nearly touch at the instant "};
      const std::size_t word = touches ? 0 : kind == EventKind::release ? 1 : 2;
      event.text = body(file, record->body_a) + " and " + body(file, record->body_b) + kWords.at(word) +
                   digits(record->time) + " s";
      events.push_back(std::move(event));
    }
    before = record;
  }
}

/// The least distance or growth over the instants, or that there was no contact at them.
void add_least(const SceneFile& file, const Track& track, std::vector<Event>& events) {
  const SceneRecord* least = nullptr;
  bool apart = true;
  for (const SceneRecord* record : track) {
    apart = apart && record->status == SceneStatus::separated;
    const double value = value_of(*record);
    if (!std::isnan(value) && (least == nullptr || value < value_of(*least))) least = record;
  }
  if (least == nullptr) {
    if (!apart) return;
    Event event = event_at(EventKind::free, *track.front(), SceneRecord::kNone);
    event.text = body(file, event.a) + " and " + body(file, event.b) + " apart at each of " +
                 std::to_string(track.size()) + " instants";
    events.push_back(std::move(event));
    return;
  }
  const bool distance = has_distance(*least);
  const std::string unit = distance ? length_unit(file, least->query) : "";
  Event event = event_at(EventKind::near, *least, least->time);
  event.value = distance ? least->lower : least->growth_lower;
  event.text = both(file, event) + ": " + (distance ? "least distance " : "least growth ") +
               digits(value_of(*least)) + unit + " at the instant " + digits(least->time) + " s";
  events.push_back(std::move(event));
}

bool more_dangerous(const Event& x, const Event& y) {
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
const Event* first_of(const std::vector<Event>& events, EventKind kind, bool continuous = false) {
  const auto found = std::find_if(events.begin(), events.end(), [&](const Event& event) {
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
    return digits(value_of(r)) + (has_distance(r) ? length_unit(file, r.query) : "") + " (" +
           file.queries.at(static_cast<std::size_t>(r.query)).name + ")";
  };
  const std::string head = is_grasp(file) ? "contact forces that the task needs: " : "answers: ";
  return head + words(*least) + (least == most ? "" : " to " + words(*most));
}

Verdict without_contact(const SceneFile& file, const std::vector<Event>& events) {
  if (const Event* open = first_of(events, EventKind::undecided))
    return {"open", "not decided: " + open->text};
  if (const Event* least = first_of(events, EventKind::near, true))
    return {"safe", "safe: never closer than " + digits_below(least->value) +
                        length_unit(file, least->query) + " to anything asked (" + both(file, *least) + ")"};
  if (first_of(events, EventKind::free, true)) return {"safe", "safe: no contact at any time, proven"};
  const bool moves = std::any_of(file.records.begin(), file.records.end(),
                                 [](const SceneRow& row) { return row.record.instant > 0; });
  if (!moves) return {"open", range_of_answers(file)};
  const Event* least = first_of(events, EventKind::near);
  return {"open", "apart at every instant asked" + (least == nullptr ? "" : "; " + least->text) +
                      "; between the instants nothing was asked"};
}

}  // namespace

std::string_view to_string(EventKind kind) noexcept {
  static constexpr std::array<std::string_view, 5> kWords = {"contact", "undecided", "near", "free",
                                                             "release"};
  return kWords.at(static_cast<std::size_t>(kind));
}

std::string length_unit(const SceneFile& file, std::int32_t query) {
  const bool lengths =
      !file.drawing.empty() && file.queries.at(static_cast<std::size_t>(query)).metric == "euclidean";
  return lengths ? " m" : "";
}

bool is_grasp(const SceneFile& file) {
  return file.drawing.empty() && file.text.find("contact_wrenches") != std::string::npos;
}

std::vector<Event> events_of(const SceneFile& file) {
  std::vector<Event> events;
  std::map<std::tuple<int, int, int>, Track> tracks;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (record.kind == SceneRowKind::instant)
      tracks[{record.query, record.body_a, record.body_b}].push_back(&record);
    else
      events.push_back(record.kind == SceneRowKind::clearance ? clearance_event(file, record)
                                                              : impact_event(file, record));
  }
  for (const auto& [key, track] : tracks) {
    add_changes(file, track, events);
    add_least(file, track, events);
  }
  std::stable_sort(events.begin(), events.end(), more_dangerous);
  return events;
}

Verdict verdict_of(const SceneFile& file) {
  if (file.records.empty())
    return {"open", file.finished() ? "no pair was asked about" : "nothing is known yet"};
  const std::vector<Event> events = events_of(file);
  if (!events.empty() && events.front().kind == EventKind::contact) {
    const Event& first = events.front();
    std::set<std::pair<std::int32_t, std::int32_t>> pairs;
    for (const Event& event : events)
      if (event.kind == EventKind::contact) pairs.emplace(event.a, event.b);
    return {"unsafe", "not safe: " + body(file, first.a) + " meets " + body(file, first.b) + " at " +
                          digits(first.time) + " s" + more_pairs(pairs.size())};
  }
  Verdict verdict = without_contact(file, events);
  if (file.finished()) return verdict;
  return {"open", "not finished (" + std::to_string(file.cells.size()) + " of " +
                      std::to_string(file.cell_count) + " cells); so far " + verdict.text};
}

}  // namespace raygauge::scene_page
