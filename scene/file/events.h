// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file/scene_file.h"

namespace raygauge {

/// What an answer says, in the order of danger.
enum class EventKind : std::uint8_t {
  contact,    ///< the bodies share a point, proven
  undecided,  ///< the bounds do not tell whether they do
  near,       ///< how near they come
  free,       ///< they never touch, or at no instant that was asked
  release,    ///< apart again after a contact
};

std::string_view to_string(EventKind kind) noexcept;

struct SceneEvent {
  EventKind kind = EventKind::free;
  std::int32_t query = 0, a = 0, b = 0;
  bool continuous = false;  ///< of all times, not of instants
  double time = 0;          ///< seconds; NaN: of the whole time
  double value = 0;         ///< of `near`: the lower bound of the distance, or of the growth; NaN otherwise
  std::string text;         ///< without the names of the query and of the bodies
};

/// What a record of a continuous effect says: "never closer than 0.2 m; 0.21 m at 3 s". A clearance that is
/// neither above 0 nor a contact, both proven, is "meet, or nearly: undecided". `unit` follows distances.
SceneEvent event_of(const SceneRecord& record, const std::string& unit = "");

/// The events of all records in their order: the answers to continuous effects, and where the bodies of a
/// pair come into contact, or apart again.
std::vector<SceneEvent> changes_of(const SceneFile& file);

/// "box – ball", as in the file.
std::string pair_name(const SceneFile& file, std::int32_t a, std::int32_t b);

/// " m" where the distances of a query are lengths of the space that is drawn, "" otherwise.
std::string length_unit(const SceneFile& file, std::int32_t query);

/// A number of an event with 6 digits, and one that is rounded down: what is said to be a lower bound has to
/// be one.
std::string event_number(double x);
std::string event_bound(double x);

}  // namespace raygauge
