// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge::cli {

/// Exit statuses of the program.
enum ExitStatus : int {
  kAnswered = 0,       ///< also for contains_origin and unreachable
  kRegression = 1,     ///< `compare` found one
  kBadInput = 2,       ///< bad usage or bad input: one line on standard error says file, place and cause
  kLimitReached = 3,   ///< an iteration, time or precision limit; bounds were printed
  kInterrupted = 130,  ///< SIGINT, what is done so far is safe; SIGTERM: 143
};

}  // namespace raygauge::cli
