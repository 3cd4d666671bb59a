// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Degenerate optima in many dimensions, integer data: column_generation beside Clp.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/ratio_rows.h"
#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"

namespace raygauge::bench {
namespace {

constexpr double kTimeLimit = 60;

// Whether the result proves what the instance was planted with.
bool is_right(const DistanceResult& result, double truth) {
  if (truth == 0) return result.status == DistanceStatus::contains_origin;
  if (std::isinf(truth)) return result.status == DistanceStatus::unreachable;
  return result.status == DistanceStatus::optimal && result.lower <= truth && truth <= result.upper;
}

double solve_seconds(SolveMethod& method, Clock clock, double limit = kTimeLimit) {
  return seconds_of([&] { method.solve({1e-6, limit}); }, clock);
}

// The median of three where one takes no time to speak of: a single one may wait for memory.
double steady_seconds(SolveMethod& method, Clock clock) {
  constexpr double kShort = 0.1;
  std::vector<double> seconds = {solve_seconds(method, clock)};
  for (int more = 0; more < 2 && seconds.front() < kShort; ++more)
    seconds.push_back(solve_seconds(method, clock));
  return sample_median(seconds);
}

// What is known of each instance of a cell when a limit ends the solve. Returns the longest overrun.
double print_cell_in_time(const Variant& family, int n, int N, const Effort& effort, double limit) {
  const std::unique_ptr<SolveMethod> ours = make_method("column_generation");
  int right = 0, bounded = 0;
  double longest = 0, least_lower = INFINITY;
  std::vector<double> uppers;
  for (int repetition = 0; repetition < effort.instances; ++repetition) {
    const Instance instance = make_instance(family, n, N, repetition);
    ours->load(instance);
    longest = std::max(longest, solve_seconds(*ours, Clock::wall, limit));
    const DistanceResult result = ours->result();
    const double truth = instance.exact_distance.value_or(NAN);
    if (!(result.lower <= truth && truth <= result.upper)) throw std::runtime_error("a false bound");
    right += is_right(result, truth) ? 1 : 0;
    bounded += result.upper < INFINITY || std::isinf(truth) ? 1 : 0;
    least_lower = std::min(least_lower, result.lower);
    uppers.push_back(result.upper);
  }
  std::printf(
      "%-20s n = %3d  N = %4d  limit %4.2g s: certified %2d of %2d, bounded above %2d, least lower %8.3g, "
      "upper: median %8.3g, worst %8.3g, longest %6.3f s\n",
      family.name.c_str(), n, N, limit, right, effort.instances, bounded, least_lower, sample_median(uppers),
      *std::max_element(uppers.begin(), uppers.end()), longest);
  std::fflush(stdout);
  return longest - limit;
}

// All instances of one cell. Returns the largest ratio.
double print_cell(const Variant& family, int n, int N, const Effort& effort) {
  const Clock clock = effort.processor_time ? Clock::processor : Clock::wall;
  const std::unique_ptr<SolveMethod> ours = make_method("column_generation");
  std::vector<std::unique_ptr<SolveMethod>> theirs;
  for (const char* name : {"clp_primal", "clp_dual"}) {
    if (has_method(name)) theirs.push_back(make_method(name));
  }
  std::vector<double> seconds, ratios;
  int right = 0;
  for (int repetition = 0; repetition < effort.instances; ++repetition) {
    const Instance instance = make_instance(family, n, N, repetition);
    double best = INFINITY;
    for (const auto& method : theirs) {
      method->load(instance);
      best = std::min(best, steady_seconds(*method, clock));
    }
    ours->load(instance);
    seconds.push_back(steady_seconds(*ours, clock));
    const DistanceResult result = ours->result();
    right += is_right(result, instance.exact_distance.value_or(NAN)) ? 1 : 0;
    ratios.push_back(seconds.back() / best);
  }
  const double worst = *std::max_element(ratios.begin(), ratios.end());
  std::printf(
      "%-22s n = %3d  N = %4d  certified %2d of %2d  median %8.2f ms, worst %8.2f ms"
      "  / Clp: median %6.2f, worst %6.2f\n",
      family.name.c_str(), n, N, right, effort.instances, 1e3 * sample_median(seconds),
      1e3 * *std::max_element(seconds.begin(), seconds.end()), sample_median(ratios), worst);
  std::fflush(stdout);
  return worst;
}

// Of all cells that `print` shows: the largest number that it returns.
double print_cells(const Effort& effort, const std::function<double(const Variant&, int, int)>& print) {
  std::vector<int> dimensions = {50, 100, 120};
  if (!effort.quick) dimensions.insert(dimensions.end(), {200, 500});
  if (!effort.dimensions.empty()) dimensions = effort.dimensions;
  double worst = -INFINITY;
  for (const int n : dimensions) {
    for (const Variant& family : planted_variants()) {
      const auto& asked = effort.families;
      if (!asked.empty() && std::find(asked.begin(), asked.end(), family.name) == asked.end()) continue;
      const std::vector<int> own = {n + 2, 3 * n / 2, 2 * n};
      for (const int N : effort.points.empty() ? own : effort.points)
        worst = std::max(worst, print(family, n, N));
    }
  }
  return worst;
}

}  // namespace

void print_degenerate(const Variant& /*variant*/, const Effort& effort) {
  for (const double limit : effort.limits) {
    const double overrun = print_cells(effort, [&](const Variant& family, int n, int N) {
      return print_cell_in_time(family, n, N, effort, limit);
    });
    std::printf("longest overrun %.4g s\n", overrun);
  }
  if (!effort.limits.empty()) return;
  std::printf("worst of all %.4g\n", print_cells(effort, [&](const Variant& family, int n, int N) {
                return print_cell(family, n, N, effort);
              }));
}

}  // namespace raygauge::bench
