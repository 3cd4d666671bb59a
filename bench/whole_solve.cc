// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// How long does a whole solve take beside the LP solvers? The solve call alone, the model being loaded; cells
// of the paper's Table III. (raygauge_ratios makes the table of ratios.)
#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bench/workload.h"

namespace raygauge::bench {
namespace {

constexpr int kInstances = 8;

// Every instance of a cell, each with a method of its own that holds its model.
struct Cell {
  Cell(const std::string& method, int n, int N) {
    for (int repetition = 0; repetition < kInstances; ++repetition) {
      instances.push_back(make_instance(find_variant("random"), n, N, repetition));
      methods.push_back(make_method(method));
      methods.back()->load(instances.back());
    }
  }
  std::vector<Instance> instances;
  std::vector<std::unique_ptr<SolveMethod>> methods;
};

void whole_solve(benchmark::State& state, const std::string& method, int n, int N) {
  const Cell cell(method, n, N);
  std::size_t next = 0;
  for (auto _ : state) {
    cell.methods[next]->solve({});
    next = (next + 1) % kInstances;
  }
}

void register_solves() {
  std::vector<std::string> methods = {"column_generation", "zheng_yamane"};
  for (const std::string& lp : lp_methods()) methods.push_back(lp);
  constexpr std::array<std::array<int, 2>, 6> kCells{
      {{3, 200}, {3, 2000}, {5, 1000}, {7, 1400}, {10, 200}, {10, 2000}}};
  for (const auto& [n, N] : kCells) {
    for (const std::string& method : methods) {
      const std::string name =
          "whole_solve/n:" + std::to_string(n) + "/N:" + std::to_string(N) + "/" + method;
      benchmark::RegisterBenchmark(name.c_str(), whole_solve, method, n, N)->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace
}  // namespace raygauge::bench

// Not at static initialization: names and defaults of the methods' parameters may not be there yet.
int main(int argc, char** argv) {
  raygauge::bench::register_solves();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
