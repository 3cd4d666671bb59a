// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/output/json_text.h"
#include "scene/file/scene_file.h"

namespace raygauge::cli {

/// How the answers to each query came about: one line a query.
std::string tally_text(const SceneFile& file);

/// What happened: contacts, releases, times of impact, least clearances; one line each, by query and time.
std::string event_text(const SceneFile& file);

/// What the file holds, as `info` prints it.
std::string scene_info_text(const std::string& path, const SceneFile& file);
Json scene_info_json(const std::string& path, const SceneFile& file);

/// One line a query and pair: least distance or growth, when, contacts. As `table` prints it.
std::string scene_table_text(const SceneFile& file);

/// How simulations went: one in some lines, several as a table.
std::string simulations_text(const SimulationTables& tables, bool contact);

}  // namespace raygauge::cli
