// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/ratio_rows.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/ratio_summary.h"
#include "bench/streaming_pass.h"
#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"
#include "raygauge/queries/solver.h"

namespace raygauge::bench {
namespace {

struct LpCell {
  std::vector<double> ours;  // seconds, in the order asked for
  double best_lp = 0;
  std::string best_name;
};

LpCell against_lp(std::vector<std::string> ours, const Variant& variant, int n, int N, int instances,
                  Clock clock = Clock::wall) {
  const std::size_t count = ours.size();
  std::vector<std::string> methods = std::move(ours);
  for (const std::string& lp : lp_methods()) methods.push_back(lp);
  if (methods.size() == count) throw std::runtime_error("this build has no LP solver to compare with");
  const std::vector<double> seconds = median_solve_seconds(methods, variant, n, N, instances, clock);
  const auto first_lp = seconds.begin() + static_cast<std::ptrdiff_t>(count);
  const auto best = std::min_element(first_lp, seconds.end());
  return {{seconds.begin(), first_lp}, *best, methods[static_cast<std::size_t>(best - seconds.begin())]};
}

// Median over instances of (whole solve / one pass over both sets), the two timed in turns.
double against_pass(const Variant& variant, int n, int N, int instances) {
  DistanceSolver solver;
  std::vector<double> ratios;
  volatile double sink = 0;
  for (int repetition = 0; repetition < instances; ++repetition) {
    const Instance instance = make_instance(variant, n, N, repetition);
    const auto solve = [&] { sink = solver.solve(*instance.A, *instance.Q).distance; };
    const auto pass = [&] { sink = streaming_pass(points_A(instance)) + streaming_pass(points_Q(instance)); };
    solve();
    pass();
    std::vector<double> solves;
    std::vector<double> passes;
    for (int turn = 0; turn < 5; ++turn) {
      solves.push_back(seconds_of(solve));
      passes.push_back(seconds_of(pass));
    }
    ratios.push_back(sample_median(solves) / sample_median(passes));
  }
  return sample_median(ratios);
}

// Median over instances of (solve by one thread / by two), the two timed in turns.
double gain_of_two_threads(const Variant& variant, int n, int N, int instances) {
  DistanceSolver one;
  DistanceOptions options;
  options.threads = 2;
  DistanceSolver two(options);
  std::vector<double> ratios;
  volatile double sink = 0;
  for (int repetition = 0; repetition < instances; ++repetition) {
    const Instance instance = make_instance(variant, n, N, repetition);
    const auto solve_by = [&](DistanceSolver& solver) {
      return seconds_of([&] { sink = solver.solve(*instance.A, *instance.Q).distance; });
    };
    std::vector<double> by_one;
    std::vector<double> by_two;
    for (int turn = 0; turn < 6; ++turn) {
      by_one.push_back(solve_by(one));
      by_two.push_back(solve_by(two));
    }
    ratios.push_back(sample_median(by_one) / sample_median(by_two));
  }
  return sample_median(ratios);
}

double print_pass_cell(const Variant& variant, int n, int N, int instances) {
  const double ratio = against_pass(variant, n, N, instances);
  std::printf("n = %3d  N = %7d  column_generation / pass %6.2f\n", n, N, ratio);
  std::fflush(stdout);
  return ratio;
}

// Student's t, two-sided 95 %, by degrees of freedom 1 … 10.
constexpr double kStudent[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};

// Least squares of log(seconds) = exponent · log(size) + constant.
void print_exponent(const char* what, const std::vector<int>& sizes, const std::vector<double>& seconds) {
  const auto count = static_cast<double>(sizes.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    mean_x += std::log(sizes[i]) / count;
    mean_y += std::log(seconds[i]) / count;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = std::log(sizes[i]) - mean_x;
    const double y = std::log(seconds[i]) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double exponent = xy / xx;
  const double error = std::sqrt((yy - exponent * xy) / (count - 2) / xx);
  std::printf("time against %s: exponent %.3f ± %.3f (95 %%, %zu sizes)\n", what, exponent,
              kStudent[sizes.size() - 3] * error, sizes.size());
}

bool is_answer(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
}

double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace

void print_grid(const Variant& variant, const Effort& effort) {
  Summary generation("column_generation / best LP");
  Summary published("zheng_yamane / best LP");
  for (int n = 3; n <= 10; n += effort.quick ? 7 : 1) {
    for (int N = 200; N <= 2000; N += effort.quick ? 900 : 200) {
      const LpCell cell = against_lp({"column_generation", "zheng_yamane"}, variant, n, N, effort.instances);
      generation.add(cell.ours[0] / cell.best_lp, n, N);
      published.add(cell.ours[1] / cell.best_lp, n, N);
      std::printf(
          "n = %2d  N = %4d  column_generation %8.2f us  / LP %.5f   zheng_yamane %8.2f us  / LP %.5f   LP "
          "%8.1f us "
          "(%s)\n",
          n, N, 1e6 * cell.ours[0], cell.ours[0] / cell.best_lp, 1e6 * cell.ours[1],
          cell.ours[1] / cell.best_lp, 1e6 * cell.best_lp, cell.best_name.c_str());
      std::fflush(stdout);
    }
  }
  generation.print();
  published.print();
}

void print_large(const Variant& variant, const Effort& effort) {
  Summary all("column_generation / pass");
  Summary largest("  at N >= 2e5");
  for (const int N :
       effort.quick ? std::vector<int>{20000, 200000} : std::vector<int>{20000, 200000, 1000000}) {
    for (const int n : {5, 10, 20}) {
      const double ratio = print_pass_cell(variant, n, N, effort.instances);
      all.add(ratio, n, N);
      if (N >= 200000) largest.add(ratio, n, N);
    }
  }
  all.print();
  largest.print();
}

void print_threads(const Variant& variant, const Effort& effort) {
  Summary all("one thread / two", Summary::Worst::smallest);
  for (const int N : effort.quick ? std::vector<int>{200000} : std::vector<int>{200000, 1000000}) {
    for (const int n : {5, 10, 20}) {
      const double gain = gain_of_two_threads(variant, n, N, effort.instances);
      std::printf("n = %3d  N = %7d  one thread / two %6.2f\n", n, N, gain);
      std::fflush(stdout);
      all.add(gain, n, N);
    }
  }
  all.print();
}

void print_n50(const Variant& variant, const Effort& effort) {
  print_pass_cell(variant, 50, 20000, effort.instances);
}

void print_high(const Variant& variant, const Effort& effort) {
  std::vector<int> dimensions = {20, 50, 100};
  if (!effort.quick) dimensions.insert(dimensions.end(), {150, 200, 400, 500});
  if (!effort.dimensions.empty()) dimensions = effort.dimensions;
  const auto print_part = [&](const char* what, const std::function<std::vector<int>(int)>& counts) {
    Summary generation(what);
    Summary zheng_yamane("  zheng_yamane");
    for (const int n : dimensions) {
      for (const int N : counts(n)) {
        const LpCell cell = against_lp({"column_generation", "zheng_yamane"}, variant, n, N, effort.instances,
                                       effort.processor_time ? Clock::processor : Clock::wall);
        std::printf("n = %3d, N = %5d: column_generation %.4g ms, zheng_yamane %.4g ms, %s %.4g ms\n", n, N,
                    cell.ours[0] * 1e3, cell.ours[1] * 1e3, cell.best_name.c_str(), cell.best_lp * 1e3);
        std::fflush(stdout);
        generation.add(cell.ours[0] / cell.best_lp, n, N);
        zheng_yamane.add(cell.ours[1] / cell.best_lp, n, N);
      }
    }
    generation.print();
    zheng_yamane.print();
  };
  print_part("column_generation, many points", [&](int n) {
    std::vector<int> counts = {3 * n, 10 * n};
    if (!effort.quick && 100 * n <= 20000) counts.push_back(100 * n);
    return counts;
  });
  print_part("column_generation, few points", [](int n) {
    return std::vector<int>{n + 2, 3 * n / 2, 2 * n};
  });
}

void print_certified(const Variant& variant, const Effort& effort) {
  std::vector<int> dimensions = {20, 50, 100};
  if (!effort.quick) dimensions.insert(dimensions.end(), {150, 200});
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    DistanceOptions options;
    options.tolerance = tolerance;
    options.time_limit = 10;
    DistanceSolver solver(options);
    int solves = 0;
    int certified = 0;
    int exact = 0;
    double worst = 0;
    for (const int n : dimensions) {
      for (const int N : {n + 2, 3 * n / 2, 2 * n, 3 * n, 10 * n}) {
        for (int repetition = 0; repetition < effort.instances; ++repetition) {
          const Instance instance = make_instance(variant, n, N, repetition);
          worst = std::max(worst, seconds_of([&] { solver.solve(*instance.A, *instance.Q); }));
          const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
          ++solves;
          certified += is_answer(result.status) ? 1 : 0;
          exact += result.counters.exact_pivots > 0 ? 1 : 0;
        }
      }
    }
    std::printf("tolerance %g: %d of %d solves certified, %d by exact arithmetic, slowest %.3g ms\n",
                tolerance, certified, solves, exact, 1e3 * worst);
    std::fflush(stdout);
  }
}

void print_n100(const Variant& variant, const Effort& effort) {
  const LpCell cell = against_lp({"column_generation"}, variant, 100, 10000, effort.instances);
  std::printf("n = 100  N = 10000  column_generation %.2f ms  / LP %.5f   LP %.1f ms (%s)\n",
              1e3 * cell.ours[0], cell.ours[0] / cell.best_lp, 1e3 * cell.best_lp, cell.best_name.c_str());
}

void print_memory(const Variant& variant, const Effort& effort) {
  const int N = effort.quick ? 100000 : 1000000;
  const Instance instance = make_instance(variant, 10, N, 0);
  const double input = bytes_of(points_A(instance)) + bytes_of(points_Q(instance));
  const double before = heap_in_use();
  DistanceSolver solver;
  solver.solve(*instance.A, *instance.Q);
  const double used = heap_in_use() - before;
  std::printf("n = 10  N = %d  input %.1f MB, solver %.3f MB: %.3f %% of the input\n", N, 1e-6 * input,
              1e-6 * used, 100 * used / input);
}

void print_growth(const Variant& variant, const Effort& effort) {
  const std::vector<int> sizes = effort.quick
                                     ? std::vector<int>{200, 2000, 20000, 200000}
                                     : std::vector<int>{200, 700, 2000, 7000, 20000, 70000, 200000, 1000000};
  std::vector<int> dimensions = {3, 5, 10, 20, 50, 100};
  if (!effort.quick) dimensions.insert(dimensions.end(), {200, 300, 400, 500});
  std::vector<double> by_N;
  std::vector<double> by_n;
  for (const int N : sizes)
    by_N.push_back(median_solve_seconds({"column_generation"}, variant, 10, N, effort.instances)[0]);
  for (const int n : dimensions) {
    by_n.push_back(median_solve_seconds({"column_generation"}, variant, n, 2000, effort.instances)[0]);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i)
    std::printf("n = 10  N = %7d  %10.1f us\n", sizes[i], 1e6 * by_N[i]);
  for (std::size_t i = 0; i < by_n.size(); ++i)
    std::printf("n = %3d  N = 2000  %10.1f us\n", dimensions[i], 1e6 * by_n[i]);
  print_exponent("N at n = 10", sizes, by_N);
  print_exponent("n at N = 2000", dimensions, by_n);
}

}  // namespace raygauge::bench
