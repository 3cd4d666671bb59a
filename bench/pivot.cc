// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does one pivot cost, by n? Whole solves over so few points that pricing them hardly counts; s/pivot is
// the time of a solve divided by its basis changes.
#include <benchmark/benchmark.h>

#include "bench/workload.h"
#include "raygauge/queries/solver.h"

namespace raygauge::bench {
namespace {

void pivot(benchmark::State& state, DistanceMethod method) {
  const int n = static_cast<int>(state.range(0));
  const Instance instance = make_instance(find_variant("random"), n, 8 * n, 0);
  DistanceOptions options;
  options.method = method;
  DistanceSolver solver(options);
  double pivots = 0;
  for (auto _ : state) pivots += static_cast<double>(solver.solve(*instance.A, *instance.Q).counters.pivots);
  state.counters["s/pivot"] =
      benchmark::Counter(pivots, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["pivots"] = benchmark::Counter(pivots, benchmark::Counter::kAvgIterations);
}

void dimensions(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("n")->Arg(2)->Arg(3)->Arg(5)->Arg(7)->Arg(10)->Arg(15)->Arg(20)->Arg(50)->Arg(100);
}

BENCHMARK_CAPTURE(pivot, column_generation, DistanceMethod::column_generation)->Apply(dimensions);
BENCHMARK_CAPTURE(pivot, zheng_yamane, DistanceMethod::zheng_yamane)->Apply(dimensions);

}  // namespace
}  // namespace raygauge::bench
