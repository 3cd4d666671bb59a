// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What do more threads bring to a batch of pairs? PairBatch on one thread, on K threads, and, as what the
// machine itself can give, K threads that each solve a share of the pairs with a batch of their own.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/pair_bodies.h"
#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"

namespace raygauge::bench {
namespace {

struct Settings {
  std::vector<std::string> kinds = {"hull200", "box", "capsule", "cylinder", "ellipsoid"};
  int pairs = 20000;
  int threads = 2;
  int rounds = 15;
};

enum class Query : unsigned char { distances, warm, growth };
constexpr const char* kNames[] = {"distances, closest points", "the same, warm", "growth distances"};

/// Pairs of all kinds in turn, each body standing somewhere, and room for the answers.
struct Workload {
  explicit Workload(const Settings& settings) {
    const std::size_t kinds = settings.kinds.size(), count = static_cast<std::size_t>(settings.pairs);
    bodies.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& one = settings.kinds[i % kinds];
      const std::string& two = settings.kinds[i / kinds % kinds];
      bodies.push_back(make_pair(one, two, "apart", static_cast<int>(i)));
    }
    for (const bench::PosedPair& body : bodies)
      pairs.push_back({{*body.first, body.pose_1}, {*body.second, body.pose_2}});
    lower.resize(count), upper.resize(count), points_1.resize(3 * count), points_2.resize(3 * count);
    warm.resize(count);
  }

  /// The pairs [from, to) by `batch`.
  void solve(PairBatch& batch, Query query, std::size_t from, std::size_t to) {
    const std::size_t size = to - from;
    const std::span some(pairs.data() + from, size);
    BatchAnswers answers;
    answers.lower = {lower.data() + from, size};
    answers.upper = {upper.data() + from, size};
    const std::span<WarmStart> starts(warm.data() + from, query == Query::warm ? size : 0);
    if (query == Query::growth) return batch.growth_distances(some, answers, starts);
    answers.closest_points_1 = {points_1.data() + 3 * from, 3 * size};
    answers.closest_points_2 = {points_2.data() + 3 * from, 3 * size};
    batch.distances(some, metric, answers, starts);
  }

  Ball metric{Eigen::Vector3d::Zero(), 1};
  std::vector<bench::PosedPair> bodies;
  std::vector<raygauge::PosedPair> pairs;
  std::vector<double> lower, upper, points_1, points_2;
  std::vector<WarmStart> warm;
};

PairBatch make_batch(int threads) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.threads = threads;
  return PairBatch(options);
}

// Threads that have nothing in common but the sets.
void solve_apart(Workload& work, std::vector<PairBatch>& batches, Query query) {
  const auto shares = static_cast<int>(batches.size());
  const std::size_t count = work.pairs.size();
#pragma omp parallel for schedule(static, 1) num_threads(shares)
  for (int k = 0; k < shares; ++k) {
    const auto share = static_cast<std::size_t>(k), all = static_cast<std::size_t>(shares);
    work.solve(batches[share], query, count * share / all, count * (share + 1) / all);
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void run(const Settings& settings) {
  Workload work(settings);
  PairBatch one = make_batch(1), many = make_batch(settings.threads);
  std::vector<PairBatch> apart;
  for (int k = 0; k < settings.threads; ++k) apart.push_back(make_batch(1));
  const std::size_t count = work.pairs.size();
  std::printf("%zu pairs; microseconds a pair, medians of %d rounds and of the ratios within them\n", count,
              settings.rounds);
  std::printf("%-28s %10s %7s %2d %10s %10s\n", "query", "1 thread", "threads", settings.threads, "speedup",
              "of apart");
  for (const Query query : {Query::distances, Query::warm, Query::growth}) {
    std::vector<double> alone, shared, speedup, ceiling;
    work.solve(one, query, 0, count);
    for (int round = 0; round < settings.rounds; ++round) {
      alone.push_back(seconds_of([&] { work.solve(one, query, 0, count); }));
      shared.push_back(seconds_of([&] { work.solve(many, query, 0, count); }));
      const double by_hand = seconds_of([&] { solve_apart(work, apart, query); });
      speedup.push_back(alone.back() / shared.back());
      ceiling.push_back(alone.back() / by_hand);
    }
    const double scale = 1e6 / static_cast<double>(count);
    std::printf("%-28s %10.3f %10.3f %10.2f %10.2f\n", kNames[static_cast<std::size_t>(query)],
                scale * median(alone), scale * median(shared), median(speedup), median(ceiling));
  }
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("--kinds", settings.kinds, "bodies, separated by commas; every pair of them")
      ->delimiter(',')
      ->check(CLI::IsMember(body_kinds()));
  app.add_option("--pairs", settings.pairs, "pairs of the batch")->check(CLI::Range(1, 10000000));
  app.add_option("--threads", settings.threads)->check(CLI::Range(2, 64));
  app.add_option("--rounds", settings.rounds)->check(CLI::Range(1, 1000));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options("raygauge_batch", "Batches of pairs on one thread and on several.",
                                           raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
