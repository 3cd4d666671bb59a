// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/console/command_line.h"
#include "cli/console/exit_status.h"

namespace raygauge::cli {

/// Each subcommand is one file, command_NAME.cc, that adds itself to the program and, when chosen, leaves its
/// exit status in `status`. Errors are thrown as raygauge::Error; program.cc prints them as one line and
/// exits with kBadInput.
void add_run_command(Command& app, int& status);
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
