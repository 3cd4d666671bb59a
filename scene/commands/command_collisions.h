// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/console/command_line.h"

namespace raygauge::cli {

/// raygauge scene collisions: which links of a robot never, always or sometimes meet.
void add_collisions_command(Command& scene, int& status);

}  // namespace raygauge::cli
