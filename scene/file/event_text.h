// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/scene/scene_record.h"

namespace raygauge {

/// What a record of a continuous effect says, for people: "never closer than 0.2; 0.21 at 3 s". A clearance
/// that is neither above 0 nor a contact, both proven, is "meet, or nearly: undecided".
std::string event_text(const SceneRecord& record);

}  // namespace raygauge
