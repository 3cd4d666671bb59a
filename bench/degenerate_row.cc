// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Degenerate optima in many dimensions, integer data: column_generation beside Clp.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/ratio_rows.h"
#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"

namespace raygauge::bench {
namespace {

constexpr double kTimeLimit = 60;

const std::vector<Variant>& families() {
  const Parameters few = {{"ties", 0.05}};
  const Parameters none = {{"ties", 0.05}, {"entry", std::int64_t{1}}};
  const Parameters sheared = {{"ties", 0.05}, {"entry", std::int64_t{1000}}};
  const auto inside = [](Parameters parameters) {
    parameters["place"] = std::string("interior");
    return parameters;
  };
  static const std::vector<Variant> all = {{"ties", "hard_planted_ties", few},
                                           {"ties, sheared", "hard_planted_unimodular", sheared},
                                           {"origin on a face", "hard_planted_origin", none},
                                           {"on a face, sheared", "hard_planted_origin", sheared},
                                           {"origin inside", "hard_planted_origin", inside(none)},
                                           {"inside, sheared", "hard_planted_origin", inside(sheared)},
                                           {"unreachable", "hard_planted_unreachable", none},
                                           {"unreachable, sheared", "hard_planted_unreachable", sheared}};
  return all;
}

// Whether the result proves what the instance was planted with.
bool is_right(const DistanceResult& result, double truth) {
  if (truth == 0) return result.status == DistanceStatus::contains_origin;
  if (std::isinf(truth)) return result.status == DistanceStatus::unreachable;
  return result.status == DistanceStatus::optimal && result.lower <= truth && truth <= result.upper;
}

double solve_seconds(SolveMethod& method, Clock clock, double limit = kTimeLimit) {
  return seconds_of([&] { method.solve({1e-6, limit}); }, clock);
}

// upper / lower - 1; 0 where nothing is left to say.
double relative_gap(const DistanceResult& result) {
  return result.lower == result.upper ? 0 : result.upper / result.lower - 1;
}

// What is known of each instance of a cell when a limit ends the solve. Returns the longest overrun.
double print_cell_in_time(const Variant& family, int n, int N, const Effort& effort) {
  const std::unique_ptr<SolveMethod> ours = make_method("column_generation");
  int right = 0, bounded = 0;
  double longest = 0;
  std::vector<double> gaps;
  for (int repetition = 0; repetition < effort.instances; ++repetition) {
    const Instance instance = make_instance(family, n, N, repetition);
    ours->load(instance);
    longest = std::max(longest, solve_seconds(*ours, Clock::wall, effort.limit));
    const DistanceResult result = ours->result();
    const double truth = instance.exact_distance.value_or(NAN);
    right += is_right(result, truth) ? 1 : 0;
    bounded += result.upper < INFINITY || std::isinf(truth) ? 1 : 0;
    gaps.push_back(relative_gap(result));
  }
  std::printf(
      "%-22s n = %3d  N = %4d  certified %2d of %2d, bounded above %2d  gap: median %8.2g, worst %8.2g  "
      "longest %6.2f s\n",
      family.name.c_str(), n, N, right, effort.instances, bounded, sample_median(gaps),
      *std::max_element(gaps.begin(), gaps.end()), longest);
  std::fflush(stdout);
  return longest - effort.limit;
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
      best = std::min(best, solve_seconds(*method, clock));
    }
    ours->load(instance);
    seconds.push_back(solve_seconds(*ours, clock));
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

}  // namespace

void print_degenerate(const Variant& /*variant*/, const Effort& effort) {
  std::vector<int> dimensions = {50, 100, 120};
  if (!effort.quick) dimensions.insert(dimensions.end(), {200, 500});
  if (!effort.dimensions.empty()) dimensions = effort.dimensions;
  double worst = 0;
  for (const int n : dimensions) {
    for (const Variant& family : families()) {
      for (const int N : {n + 2, 3 * n / 2, 2 * n}) {
        const auto print = effort.limit > 0 ? print_cell_in_time : print_cell;
        worst = std::max(worst, print(family, n, N, effort));
      }
    }
  }
  std::printf(effort.limit > 0 ? "longest overrun %.4g s\n" : "worst of all %.4g\n", worst);
}

}  // namespace raygauge::bench
