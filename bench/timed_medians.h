// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/workload.h"

namespace raygauge::bench {

/// Wall time, or the processor time of the calling thread, which other work on the machine does not lengthen
/// by its share.
enum class Clock : std::uint8_t { wall, processor };

/// Seconds of one call.
double seconds_of(const std::function<void()>& call, Clock clock = Clock::wall);

/// Microseconds of each call: the calls take turns in `rounds`, in each of which one is made once and then
/// `repeats` times; the median of the rounds' means.
std::vector<double> microseconds_in_turn(const std::vector<std::function<void()>>& calls, int rounds,
                                         int repeats, Clock clock = Clock::wall);

/// Seconds of a cold solve of the loaded model at the default request: solved once before, then the median of
/// three; short solves are repeated.
double cold_solve_seconds(SolveMethod& method, Clock clock = Clock::wall);

/// Median seconds of the solve call of each method over the instances 0 … instances - 1 of a cell. On every
/// instance the methods take turns, each beginning in turn; a model is loaded and solved once before its
/// solves are timed, and the median of three stands for the instance.
std::vector<double> median_solve_seconds(const std::vector<std::string>& methods, const Variant& variant,
                                         int n, int N, int instances, Clock clock = Clock::wall);

}  // namespace raygauge::bench
