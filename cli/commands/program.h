// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge::cli {

/// The whole program: runs the command that the arguments name and returns its exit status. Throws nothing:
/// an error is one line on standard error.
int run_program(int argc, char** argv);

}  // namespace raygauge::cli
