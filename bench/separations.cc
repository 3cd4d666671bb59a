// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// How long does it take to prove whether two primitives or small hulls are separated: in a batch, by each
// instruction set, and by single tests?
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "bench/pair_bodies.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::bench {
namespace {

constexpr int kPairs = 4096;

// Pairs of these kinds in turn, each body with a set and a pose of its own, at places of a scene: some apart,
// some overlapping. Whether they meet is shuffled.
struct Workload {
  Workload(const std::vector<std::string>& kinds, const std::string& place) {
    for (std::size_t i = 0; i < kPairs; ++i) {
      const std::string& one = kinds[i % kinds.size()];
      const std::string& two = kinds[i / kinds.size() % kinds.size()];
      const bool overlap = place == "both" ? i * 2654435761U % 4096 < 2048 : place == "overlap";
      const std::string where = place == "parallel" ? place : overlap ? "overlap" : "apart";
      bodies.push_back(make_pair(one, two, where, static_cast<int>(i)));
    }
    for (const bench::PosedPair& body : bodies)
      pairs.push_back({{*body.first, body.pose_1}, {*body.second, body.pose_2}});
  }

  std::vector<bench::PosedPair> bodies;
  std::vector<raygauge::PosedPair> pairs;
};

DistanceOptions options_for(InstructionSet isa) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.instruction_set = isa;
  return options;
}

void report(benchmark::State& state) {
  state.counters["a_pair"] =
      benchmark::Counter(kPairs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void batch(benchmark::State& state, const std::vector<std::string>& kinds, const std::string& place,
           InstructionSet isa) {
  const Workload work(kinds, place);
  std::vector<Separation> outcome(work.pairs.size());
  try {
    PairBatch batch(options_for(isa), 1);
    batch.separations(work.pairs, {outcome, {}});
    for (auto _ : state) batch.separations(work.pairs, {outcome, {}});
    report(state);
  } catch (const InvalidParameterError& error) {
    state.SkipWithError(error.what());
  }
}

void single(benchmark::State& state, const std::vector<std::string>& kinds, const std::string& place) {
  const Workload work(kinds, place);
  GrowthDistanceSolver solver(options_for(InstructionSet::automatic));
  std::vector<Separation> outcome(work.pairs.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < work.pairs.size(); ++i)
      outcome[i] = solver.separation(work.pairs[i].first, work.pairs[i].second).outcome;
    benchmark::DoNotOptimize(outcome.data());
  }
  report(state);
}

void add(const std::string& name, const std::vector<std::string>& kinds, const std::string& place) {
  const auto of = [&](const char* how) { return name + "/" + place + "/" + how; };
  const auto lanes = [&](const char* how, InstructionSet isa) {
    benchmark::RegisterBenchmark(of(how).c_str(), batch, kinds, place, isa);
  };
  lanes("avx512", InstructionSet::avx512);
  lanes("avx2", InstructionSet::avx2);
  lanes("baseline", InstructionSet::baseline);
  benchmark::RegisterBenchmark(of("single").c_str(), single, kinds, place);
}

const bool kRegistered = [] {
  const std::vector<std::string> all = {"box", "ball", "capsule"};
  for (const std::string place : {"apart", "overlap", "both", "parallel"}) {
    for (const std::string& kind : all) add(kind, {kind}, place);
    add("all", all, place);
    for (const std::string hull : {"hull8", "points20"}) add(hull, {hull}, place);
    add("hull and others", {"hull8", "box", "ball", "capsule"}, place);
  }
  return true;
}();

}  // namespace
}  // namespace raygauge::bench
