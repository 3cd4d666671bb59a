// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/console/command_line.h"

namespace raygauge::cli {

/// Adds `raygauge scene run` and `raygauge scene explain`, as the commands of cli/commands/commands.h.
void add_scene_command(Command& app, int& status);

}  // namespace raygauge::cli
