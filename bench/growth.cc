// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// How does the time grow with N (at n = 10) and with n (at N = 2000)? (raygauge_ratios --rows growth fits the
// exponents.)
#include <benchmark/benchmark.h>

#include "bench/workload.h"
#include "raygauge/queries/solver.h"

namespace raygauge::bench {
namespace {

void solve(benchmark::State& state, DistanceMethod method, int n, int N) {
  const Instance instance = make_instance(find_variant("random"), n, N, 0);
  DistanceOptions options;
  options.method = method;
  DistanceSolver solver(options);
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(*instance.A, *instance.Q).distance);
}

void growth_with_N(benchmark::State& state, DistanceMethod method) {
  solve(state, method, 10, static_cast<int>(state.range(0)));
}

void growth_with_n(benchmark::State& state, DistanceMethod method) {
  solve(state, method, static_cast<int>(state.range(0)), 2000);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("N")->Unit(benchmark::kMicrosecond);
  for (const int N : {200, 1000, 5000, 20000, 100000, 400000, 1000000}) benchmark->Arg(N);
}

void dimensions(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("n")->Unit(benchmark::kMicrosecond);
  for (const int n : {2, 3, 5, 10, 20, 50, 100}) benchmark->Arg(n);
}

BENCHMARK_CAPTURE(growth_with_N, column_generation, DistanceMethod::column_generation)->Apply(sizes);
BENCHMARK_CAPTURE(growth_with_n, column_generation, DistanceMethod::column_generation)->Apply(dimensions);
BENCHMARK_CAPTURE(growth_with_n, zheng_yamane, DistanceMethod::zheng_yamane)->Apply(dimensions);

}  // namespace
}  // namespace raygauge::bench
