// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does memory cost? The first solve of a new solver against a repeated one: time, calls of operator new,
// and bytes asked for as a share of the points themselves.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdlib>
#include <new>

#include "bench/streaming_pass.h"
#include "bench/workload.h"
#include "raygauge/queries/solver.h"

namespace {
double calls = 0;
double bytes = 0;

void* counted(std::size_t size, std::size_t alignment) {
  calls += 1;
  bytes += static_cast<double>(size);
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace raygauge::bench {
namespace {

void report(benchmark::State& state, const Instance& instance) {
  const auto solves = static_cast<double>(state.iterations());
  state.counters["allocations"] = calls / solves;
  state.counters["share_of_input"] =
      bytes / solves / (bytes_of(points_A(instance)) + bytes_of(points_Q(instance)));
}

Instance instance_of(const benchmark::State& state) {
  return make_instance(find_variant("random"), static_cast<int>(state.range(0)),
                       static_cast<int>(state.range(1)), 0);
}

void first_solve(benchmark::State& state) {
  const Instance instance = instance_of(state);
  calls = bytes = 0;
  for (auto _ : state) benchmark::DoNotOptimize(DistanceSolver().solve(*instance.A, *instance.Q).distance);
  report(state, instance);
}

void repeated_solve(benchmark::State& state) {
  const Instance instance = instance_of(state);
  DistanceSolver solver;
  solver.solve(*instance.A, *instance.Q);
  calls = bytes = 0;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(*instance.A, *instance.Q).distance);
  report(state, instance);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"n", "N"})->Unit(benchmark::kMicrosecond);
  benchmark->ArgsProduct({{3, 10}, {200, 2000, 200000}})->Args({10, 1000000});
}

BENCHMARK(first_solve)->Apply(sizes);
BENCHMARK(repeated_solve)->Apply(sizes);

}  // namespace
}  // namespace raygauge::bench
