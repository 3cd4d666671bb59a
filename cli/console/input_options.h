// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/console/command_line.h"
#include "engine/sweep/pieces.h"

namespace raygauge::cli {

/// --max-input, of the commands that read sets.
void add_max_input_option(Command& command);

/// The value of --shard, as in "3/7". Throws InvalidParameterError.
Shard shard_from(const std::string& text);

}  // namespace raygauge::cli
