// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/console/command_line.h"

namespace raygauge::cli {

/// Adds `raygauge scene` and its commands, as the commands of cli/commands/commands.h.
void add_scene_command(Command& app, int& status);

/// Of these: bodies that react; which links of a robot never, always or sometimes meet.
void add_simulate_command(Command& scene, int& status);
void add_collisions_command(Command& scene, int& status);

}  // namespace raygauge::cli
