// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file/scene_file.h"

namespace raygauge::scene_page {

/// What the answers of a scene say, in the order of danger.
enum class EventKind : std::uint8_t {
  contact,    ///< the bodies share a point, proven
  undecided,  ///< the bounds do not tell whether they do
  near,       ///< how near they come
  free,       ///< they never touch, or at no instant that was asked
  release,    ///< apart again after a contact
};

std::string_view to_string(EventKind kind) noexcept;

struct Event {
  EventKind kind = EventKind::free;
  std::int32_t query = 0, a = 0, b = 0;
  bool continuous = false;  ///< of all times, not of instants
  double time = 0;          ///< seconds; NaN: of the whole time
  double value = 0;         ///< of `near`: the lower bound of the distance, or of the growth; NaN otherwise
  std::string text;         ///< one sentence without the name of the query
};

/// Every contact, release and least distance of every query and pair; contacts by time, then what is near,
/// the nearest first.
std::vector<Event> events_of(const SceneFile& file);

struct Verdict {
  std::string state;  ///< "safe", "unsafe", "open" where that was not asked or not decided
  std::string text;   ///< "safe: never closer than 0.047 m to anything asked (hand – bunny)"
};

/// Whether bodies meet, in one line: the first of the page.
Verdict verdict_of(const SceneFile& file);

/// " m" where the distances of a query are lengths of the space that is drawn, "" otherwise.
std::string length_unit(const SceneFile& file, std::int32_t query);

/// Whether the bodies of the scene are wrenches of contacts: its distances are forces.
bool is_grasp(const SceneFile& file);

}  // namespace raygauge::scene_page
