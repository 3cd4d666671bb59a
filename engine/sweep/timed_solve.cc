// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/method.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

/// Below this a duration is the clock's own.
constexpr double kClockResolution = 2e-8;

double time_batch(SolveMethod& method, const SolveRequest& request, int solves) {
  const SteadyClock::time_point start = SteadyClock::now();
  for (int i = 0; i < solves; ++i) method.solve(request);
  return seconds_since(start);
}

}  // namespace

TimedSolve time_solve(SolveMethod& method, const SolveRequest& request, double min_seconds) {
  double seconds_per_solve = time_batch(method, request, 1);
  if (seconds_per_solve >= min_seconds) return {seconds_per_solve, 1};
  double total = 0;
  int solves = 0;
  // The first solve met cold caches, so one batch may fall short and a second one complete the sample.
  while (total < min_seconds) {
    const double missing = (min_seconds - total) / std::max(seconds_per_solve, kClockResolution);
    const int batch = static_cast<int>(std::ceil(missing));
    total += time_batch(method, request, batch);
    solves += batch;
    seconds_per_solve = total / solves;
  }
  return {seconds_per_solve, solves};
}

}  // namespace raygauge
