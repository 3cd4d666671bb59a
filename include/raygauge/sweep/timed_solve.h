// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

#include "raygauge/sweep/method.h"

namespace raygauge {

using SteadyClock = std::chrono::steady_clock;

/// Seconds from `start` until now.
inline double seconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

/// One sample of a solve's time.
struct TimedSolve {
  double seconds = 0;         ///< of one solve: total / inner_repetitions
  int inner_repetitions = 1;  ///< solves in the sample
};

/// Times solves of the loaded model. A first solve that lasts `min_seconds` or longer is the sample.
/// After a shorter one, as many solves as fill `min_seconds` are timed together, without the first.
/// Allocates nothing.
TimedSolve time_solve(SolveMethod& method, const SolveRequest& request, double min_seconds);

/// What takes a sample: time_solve, or in a test something that needs no clock.
using SolveTimer = std::function<TimedSolve(SolveMethod&, const SolveRequest&, double min_seconds)>;

}  // namespace raygauge
