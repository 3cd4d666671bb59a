// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/timed_medians.h"

#include <time.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>

#include "engine/sweep/order_statistics.h"
#include "raygauge/sweep/method.h"

namespace raygauge::bench {
namespace {

/// As in a sweep: short solves are repeated until they fill this time, ours and the competition's alike.
constexpr double kMinSeconds = 2e-4;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double seconds_of(const std::function<void()>& call, Clock clock) {
  const auto now = [clock] {
    if (clock == Clock::processor) return processor_seconds();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const double begin = now();
  call();
  return now() - begin;
}

std::vector<double> microseconds_in_turn(const std::vector<std::function<void()>>& calls, int rounds,
                                         int repeats, Clock clock) {
  std::vector<std::vector<double>> means(calls.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t c = 0; c < calls.size(); ++c) {
      const auto& call = calls[c];
      call();
      const auto repeat = [&call, repeats] {
        for (int i = 0; i < repeats; ++i) call();
      };
      means[c].push_back(1e6 / repeats * seconds_of(repeat, clock));
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& of_call : means) medians.push_back(sample_median(std::move(of_call)));
  return medians;
}

double cold_solve_seconds(SolveMethod& method, Clock clock) {
  if (clock == Clock::wall) return time_solve(method, {}, kMinSeconds).seconds;
  const double begin = processor_seconds();
  int solves = 0;
  double spent = 0;
  while (spent < kMinSeconds) {
    method.solve({});
    ++solves;
    spent = processor_seconds() - begin;
  }
  return spent / solves;
}

std::vector<double> median_solve_seconds(const std::vector<std::string>& methods, const Variant& variant,
                                         int n, int N, int instances, Clock clock) {
  std::vector<std::unique_ptr<SolveMethod>> solvers;
  for (const std::string& name : methods) solvers.push_back(make_method(name));
  std::vector<std::vector<double>> seconds(methods.size());
  for (int repetition = 0; repetition < instances; ++repetition) {
    const Instance instance = make_instance(variant, n, N, repetition);
    for (std::size_t turn = 0; turn < methods.size(); ++turn) {
      const std::size_t m = (turn + static_cast<std::size_t>(repetition)) % methods.size();
      SolveMethod& solver = *solvers[m];
      solver.load(instance);
      seconds[m].push_back(cold_solve_seconds(solver, clock));
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& of_method : seconds) medians.push_back(sample_median(std::move(of_method)));
  return medians;
}

}  // namespace raygauge::bench
