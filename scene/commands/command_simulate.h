// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/console/command_line.h"

namespace raygauge::cli {

/// Adds `simulate` to the command `scene`.
void add_simulate_command(Command& scene, int& status);

}  // namespace raygauge::cli
