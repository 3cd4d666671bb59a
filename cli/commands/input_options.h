// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands/command_line.h"

namespace raygauge::cli {

/// --max-input, of the commands that read sets.
void add_max_input_option(Command& command);

}  // namespace raygauge::cli
