// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// How long does it take to prove whether each of 10^5 points lies in a hull of 2000 points of R^10, and to
// bound its gauge, on one thread, in one call and by single calls?
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "raygauge/queries/membership.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::bench {
namespace {

constexpr int kDimension = 10, kHull = 2000, kPoints = 100000, kSingle = 500;

Eigen::MatrixXd on_sphere(int count, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(kDimension, count);
  for (double& x : points.reshaped()) x = normal(random);
  points.colwise().normalize();
  return points;
}

// A hull of points of the unit sphere, and points uniform in a ball whose radius is state.range(0)
// hundredths.
struct Workload {
  explicit Workload(const benchmark::State& state) : hull(on_sphere(kHull, random)) {
    std::uniform_real_distribution<double> uniform;
    points = on_sphere(kPoints, random);
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i) *=
          0.01 * static_cast<double>(state.range(0)) * std::pow(uniform(random), 1.0 / kDimension);
  }

  std::mt19937_64 random{1};
  PointSet hull;
  Eigen::MatrixXd points;
};

void report(benchmark::State& state, int count) {
  state.counters["a_point"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void contains_batch(benchmark::State& state) {
  const Workload work(state);
  for (auto _ : state) benchmark::DoNotOptimize(memberships(work.hull, work.points).data());
  report(state, kPoints);
}

void gauge_batch(benchmark::State& state) {
  const Workload work(state);
  PointsOptions options;
  options.threads = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(gauges(work.hull, work.points, options).data());
  report(state, kPoints);
}

void contains_single(benchmark::State& state) {
  const Workload work(state);
  for (auto _ : state) {
    for (Eigen::Index i = 0; i < kSingle; ++i)
      benchmark::DoNotOptimize(contains(work.hull, work.points.col(i)));
  }
  report(state, kSingle);
}

void gauge_single(benchmark::State& state) {
  const Workload work(state);
  for (auto _ : state) {
    for (Eigen::Index i = 0; i < kSingle; ++i)
      benchmark::DoNotOptimize(gauge(work.hull, work.points.col(i)).lower);
  }
  report(state, kSingle);
}

void distances(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("percent")->Unit(benchmark::kMillisecond);
  for (const int percent : {50, 70, 100, 200}) benchmark->Arg(percent);
}

void distances_on_threads(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"percent", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int percent : {50, 70, 100, 200}) {
    for (const int threads : {1, 2}) benchmark->Args({percent, threads});
  }
}

BENCHMARK(contains_batch)->Apply(distances);
BENCHMARK(contains_single)->Apply(distances);
BENCHMARK(gauge_batch)->Apply(distances_on_threads);
BENCHMARK(gauge_single)->Apply(distances);

}  // namespace
}  // namespace raygauge::bench
