// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/program.h"

int main(int argc, char** argv) { return raygauge::cli::run_program(argc, argv); }
