// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/file/scene_file.h"
#include "scene/queries/effects.h"

namespace raygauge {

/// What a record of an effect over the whole time says.
SceneEvent event_of(const SceneFile& file, const SceneRecord& record);

/// The events of all records in their order: the answers to continuous effects, and where the bodies of a
/// pair come into contact, or apart again.
std::vector<SceneEvent> changes_of(const SceneFile& file);

/// "box – ball", as in the file.
std::string pair_name(const SceneFile& file, std::int32_t a, std::int32_t b);

/// " m" where the distances of a query are lengths of the space that is drawn, "" otherwise.
std::string length_unit(const SceneFile& file, std::int32_t query);

}  // namespace raygauge
