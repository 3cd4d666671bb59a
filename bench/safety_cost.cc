// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What proofs cost: solves of Table III's grid against the same solves that end where the simplex says so,
// with no bound checked. Ratio of medians over the instances of a cell; both are timed in turns, the best of
// several each.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "bench/workload.h"
#include "engine/methods/column_generation/sifting.h"
#include "engine/sweep/order_statistics.h"

namespace raygauge::bench {
namespace {

struct Settings {
  int instances = 20;
  int rounds = 15;
  double tolerance = 1e-6;
};

struct Pair {
  double proven = std::numeric_limits<double>::infinity();
  double trusted = std::numeric_limits<double>::infinity();
};

double seconds_of(Sifting& solver, const Instance& instance, const DistanceOptions& options,
                  DistanceResult& result) {
  constexpr int kRepeats = 8;  // a solve is short against the clock's resolution
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kRepeats; ++i) {
    solver.solve(points_A(instance), points_Q(instance), options, Stopwatch(), Effects::none, result);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / kRepeats;
}

// Medians over the cell's instances, of the best of the rounds.
Pair measure_cell(int n, int N, const Settings& settings) {
  Sifting proving, trusting;
  trusting.trust_simplex(true);
  DistanceOptions options;
  options.tolerance = settings.tolerance;
  DistanceResult result;
  std::vector<double> proven, trusted;
  for (int repetition = 0; repetition < settings.instances; ++repetition) {
    const Instance instance = make_instance(find_variant("random"), n, N, repetition);
    Pair best;
    for (int round = 0; round < settings.rounds; ++round) {
      best.proven = std::min(best.proven, seconds_of(proving, instance, options, result));
      best.trusted = std::min(best.trusted, seconds_of(trusting, instance, options, result));
    }
    proven.push_back(best.proven);
    trusted.push_back(best.trusted);
  }
  return {sample_median(proven), sample_median(trusted)};
}

void print_grid(const Settings& settings) {
  std::printf("tolerance %g; us with proofs / us without = ratio\n", settings.tolerance);
  std::vector<double> ratios;
  for (const int N : {200, 600, 1000, 2000}) {
    for (int n = 3; n <= 10; ++n) {
      const Pair cell = measure_cell(n, N, settings);
      ratios.push_back(cell.proven / cell.trusted);
      std::printf("n = %2d, N = %4d: %8.2f / %8.2f = %.3f\n", n, N, 1e6 * cell.proven, 1e6 * cell.trusted,
                  ratios.back());
    }
  }
  std::printf("ratio over the grid: median %.3f, largest %.3f\n", sample_median(ratios),
              *std::max_element(ratios.begin(), ratios.end()));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  CLI::App app{"What the proofs cost on the grid of Table III."};
  raygauge::bench::Settings settings;
  app.option_defaults()->always_capture_default();
  app.add_option("--instances", settings.instances, "instances a cell")->check(CLI::PositiveNumber);
  app.add_option("--rounds", settings.rounds, "timings of each instance")->check(CLI::PositiveNumber);
  app.add_option("--tolerance", settings.tolerance, "relative gap")->check(CLI::Range(1e-15, 0.5));
  CLI11_PARSE(app, argc, argv);
  try {
    raygauge::bench::print_grid(settings);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raygauge_safety_cost: %s\n", error.what());
    return 2;
  }
}
