// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/commands/command_line.h"
#include "results/run/output_place.h"

namespace raygauge::cli {

/// --force of a command whose output can be made again.
void add_force_option(Command& command, bool& force);

/// Writes where output_place() allows: to standard output, a stream or a file. Throws OutputRefusedError and
/// ResultsError.
void write_to(const OutputRequest& request, const std::string& bytes);

/// The path of what was written, on a line of standard output, unless that is where it went.
void print_path(const OutputRequest& request);

}  // namespace raygauge::cli
