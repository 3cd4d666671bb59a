// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// How far is a support query from a mere read of the same bytes? Both in bytes per second, in one run.
#include <benchmark/benchmark.h>

#include "bench/streaming_pass.h"
#include "bench/workload.h"
#include "engine/kernels/kernel.h"

namespace raygauge::bench {
namespace {

Instance instance_of(const benchmark::State& state) {
  return make_instance(find_variant("random"), static_cast<int>(state.range(0)),
                       static_cast<int>(state.range(1)), 0);
}

void report(benchmark::State& state, const PointSet& S) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes_of(S)) * state.iterations());
}

void support_query(benchmark::State& state) {
  const Instance instance = instance_of(state);
  const PointSet& S = points_Q(instance);
  const Vector u = S.point(0);
  const Kernels& kernels = best_kernels();
  std::ptrdiff_t index = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(kernels.price(S.data(), S.block_count(), S.dimension(), u.data(), &index));
  }
  report(state, S);
}

void streaming_read(benchmark::State& state) {
  const Instance instance = instance_of(state);
  const PointSet& S = points_Q(instance);
  for (auto _ : state) benchmark::DoNotOptimize(streaming_pass(S));
  report(state, S);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"n", "N"})->ArgsProduct({{3, 5, 10, 20, 50}, {200, 2000, 20000, 200000, 1000000}});
}

BENCHMARK(support_query)->Apply(sizes);
BENCHMARK(streaming_read)->Apply(sizes);

}  // namespace
}  // namespace raygauge::bench
