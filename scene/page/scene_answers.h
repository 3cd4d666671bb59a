// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "scene/file/events.h"

namespace raygauge::scene_page {

/// Every contact, release and least distance of every query and pair; contacts by time, then what is near,
/// the nearest first.
std::vector<SceneEvent> events_of(const SceneFile& file);

struct Verdict {
  std::string state;  ///< "safe", "unsafe", "open" where that was not asked or not decided
  std::string text;   ///< "safe: never closer than 0.047 m to anything asked (hand – bunny)"
};

/// Whether bodies meet, in one line: the first of the page.
Verdict verdict_of(const SceneFile& file);

/// Whether the bodies of the scene are wrenches of contacts: its distances are forces.
bool is_grasp(const SceneFile& file);

}  // namespace raygauge::scene_page
