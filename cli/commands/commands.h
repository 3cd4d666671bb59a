// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands/command_line.h"

namespace raygauge::cli {

/// Exit statuses of the program.
enum ExitStatus : int {
  kAnswered = 0,       ///< also for contains_origin and unreachable
  kRegression = 1,     ///< `compare` found one
  kBadInput = 2,       ///< bad usage or bad input: one line on standard error says file, place and cause
  kLimitReached = 3,   ///< an iteration, time or precision limit; bounds were printed
  kInterrupted = 130,  ///< SIGINT, what is done so far is safe; SIGTERM: 143
};

/// Each subcommand is one file, command_NAME.cc, that adds itself to the program and, when chosen, leaves its
/// exit status in `status`. Errors are thrown as raygauge::Error; program.cc prints them as one line and
/// exits with kBadInput.
void add_run_command(Command& app, int& status);
void add_scene_command(Command& app, int& status);
void add_distance_command(Command& app, int& status);
void add_table_command(Command& app, int& status);
void add_plot_command(Command& app, int& status);
void add_export_command(Command& app, int& status);
void add_compare_command(Command& app, int& status);
void add_report_command(Command& app, int& status);
void add_info_command(Command& app, int& status);
void add_merge_command(Command& app, int& status);
void add_submit_command(Command& app, int& status);

}  // namespace raygauge::cli
