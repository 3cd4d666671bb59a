// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/console/command_line.h"
#include "results/run/output_place.h"

namespace raygauge::cli {

/// --force of a command whose output can be made again.
void add_force_option(Command& command, bool& force);

/// An output of a command, after output_place() has decided where it goes. The decision is made once: a file
/// that the command itself has written does not change it.
struct Output {
  std::string path;  ///< as the user gave it
  OutputPlace place;
};

/// Asks output_place(). Throws OutputRefusedError.
Output decided(const OutputRequest& request);

/// An output with its content.
struct Written {
  Output output;
  std::string bytes;
};

/// Writes to standard output, a stream or a file. Throws ResultsError, and what `source` throws.
void write_to(const Output& output, const ByteSource& source);
void write_to(const Output& output, const std::string& bytes);

/// The path of what was written, on a line of standard output, unless that is where it went.
void print_path(const Output& output);

/// Writes all outputs of a command and prints their paths. All of them are decided by then: none is written
/// where one is refused.
void write_all(const std::vector<Written>& outputs);

}  // namespace raygauge::cli
