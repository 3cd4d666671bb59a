// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/library_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"

namespace raygauge::bench {
namespace {

constexpr int kRounds = 7;
constexpr int kCalls = 100;  // reading the thread's clock takes longer than a distance of two balls
constexpr double kWrong = 1e-5;

struct Truth {
  double lower = 0, upper = 0;
  bool certified = false;
};

// One query of ours, cold and warm: that one to and fro between both poses, each from the memory of the
// other.
struct Ours {
  std::function<void()> cold, warm;
};

void judge(const raygauge_pair_answer& answer, bool solved, const Truth& truth, double unit,
           LibraryTally& tally) {
  ++tally.pairs;
  if (truth.certified) ++tally.certified;
  const double off = std::max({0.0, answer.value - truth.upper, truth.lower - answer.value}) / unit;
  if (solved && off <= kWrong) return;
  ++tally.wrong;
  if (solved) tally.worst = std::max(tally.worst, off);
}

struct Contender {
  const raygauge_pair_library& library;
  const PosedPair& pair;
  double tolerance;

  // Times ours beside the library's, which stands aside where it has no such pair.
  void measure(raygauge_pair_query query, const Truth& truth, double unit, const Ours& ours,
               LibraryTally& tally) const {
    LibraryPair cold(library, pair, query, tolerance), warm(library, pair, query, tolerance);
    if (!cold.has() || !warm.has()) return;
    raygauge_pair_answer answer{};
    cold.place(pair.pose_1, pair.pose_2);
    judge(answer, cold.solve(answer), truth, unit, tally);
    warm.place(pair.pose_1, pair.pose_2);
    warm.solve_and_remember(answer);
    warm.place(pair.pose_1, pair.moved_2);
    std::vector<std::function<void()>> calls = {ours.cold, [&] { cold.solve(answer); }, ours.warm};
    const bool remembers = library.memory_size > 0;
    if (remembers) calls.emplace_back([&] { warm.solve_warm(answer); });
    const std::vector<double> times = microseconds_in_turn(calls, kRounds, kCalls, Clock::processor);
    tally.ours.push_back(times[0]);
    tally.theirs.push_back(times[1]);
    tally.ours_warm.push_back(times[2]);
    if (remembers) tally.theirs_warm.push_back(times[3]);
  }
};

Truth truth_of(const DistanceResult& r) {
  return {r.lower, r.upper,
          r.status == DistanceStatus::optimal || r.status == DistanceStatus::contains_origin};
}

DistanceOptions options_for(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

struct Places {
  Posed one, two, moved;
};

void measure_distance(const Contender& contender, const Places& at, LibraryTallies& tallies) {
  const Ball metric(Eigen::Vector3d::Zero(), 1);
  ObjectDistanceSolver solver(options_for(contender.tolerance));
  constexpr auto kPoints = ObjectEffects::closest_points;
  constexpr auto kDeep = kPoints | ObjectEffects::depth;
  WarmStart kept;
  const ObjectDistance& first = solver.solve(at.one, at.two, metric, kDeep, &kept);
  const bool meet = first.depth.evaluations > 0;
  const Truth truth =
      meet ? Truth{first.depth.lower, first.depth.upper, first.depth.status == DistanceStatus::optimal}
           : truth_of(first.distance);
  const auto effects = meet ? kDeep : kPoints;
  const auto query = meet ? RAYGAUGE_DEPTH : RAYGAUGE_DISTANCE;
  bool moved = false;
  Ours ours;
  ours.cold = [&] { solver.solve(at.one, at.two, metric, effects); };
  ours.warm = [&] {
    moved = !moved;
    solver.solve(at.one, moved ? at.moved : at.two, metric, effects, &kept);
  };
  contender.measure(query, truth, contender.pair.size, ours, tallies[query]);
}

void measure_growth(const Contender& contender, const Places& at, LibraryTallies& tallies) {
  GrowthDistanceSolver solver(options_for(contender.tolerance));
  WarmStart kept;
  const Truth truth = truth_of(solver.solve_about_centers(at.one, at.two, &kept));
  bool moved = false;
  Ours ours;
  ours.cold = [&] { solver.solve_about_centers(at.one, at.two); };
  ours.warm = [&] {
    moved = !moved;
    solver.solve_about_centers(at.one, moved ? at.moved : at.two, &kept);
  };
  contender.measure(RAYGAUGE_GROWTH, truth, truth.upper, ours, tallies[RAYGAUGE_GROWTH]);
}

constexpr const char* kQueries[RAYGAUGE_QUERIES] = {"distance", "depth", "growth"};

double median_or_nan(const std::vector<double>& values) {
  return values.empty() ? std::nan("") : sample_median(values);
}

void print_ratios(const char* query, const char* start, const std::vector<double>& ratios) {
  if (ratios.empty()) return;
  double logarithms = 0;
  for (const double ratio : ratios) logarithms += std::log(ratio);
  std::printf("%-9s %-5s geometric mean %.3f, largest %.3f of %zu rows\n", query, start,
              std::exp(logarithms / static_cast<double>(ratios.size())),
              *std::max_element(ratios.begin(), ratios.end()), ratios.size());
}

}  // namespace

LibraryTable::LibraryTable(const std::string& path) : loaded_(path) {
  std::printf("microseconds of raygauge beside %s, cold and warm after a motion\n", library().name);
  std::printf("%-30s %-9s %9s %9s %7s %9s %9s %7s %9s %11s %11s %8s\n", "A1 A2 place", "query", "ours",
              "theirs", "ratio", "our warm", "their w.", "ratio", "warm/cold", "certified", "wrong", "worst");
}

void LibraryTable::print(const std::string& row, const LibraryTallies& tallies) {
  for (std::size_t q = 0; q < RAYGAUGE_QUERIES; ++q) {
    const LibraryTally& tally = tallies[q];
    if (tally.pairs == 0) continue;
    const double ours = sample_median(tally.ours), theirs = sample_median(tally.theirs);
    const double ours_warm = sample_median(tally.ours_warm), theirs_warm = median_or_nan(tally.theirs_warm);
    ratios_[q].cold.push_back(ours / theirs);
    if (!tally.theirs_warm.empty()) ratios_[q].warm.push_back(ours_warm / theirs_warm);
    std::printf("%-30s %-9s %9.3f %9.3f %7.3f %9.3f %9.3f %7.3f %9.2f %5d/%-5d %5d/%-5d %8.1e\n", row.c_str(),
                kQueries[q], ours, theirs, ours / theirs, ours_warm, theirs_warm, ours_warm / theirs_warm,
                ours_warm / ours, tally.certified, tally.pairs, tally.wrong, tally.pairs, tally.worst);
  }
  std::fflush(stdout);
}

void LibraryTable::print_summary() const {
  for (std::size_t q = 0; q < RAYGAUGE_QUERIES; ++q) {
    print_ratios(kQueries[q], "cold", ratios_[q].cold);
    print_ratios(kQueries[q], "warm", ratios_[q].warm);
  }
}

void measure_beside(const raygauge_pair_library& library, const PosedPair& pair, double tolerance,
                    LibraryTallies& tallies) {
  const Contender contender{library, pair, tolerance};
  const Places at{{*pair.first, pair.pose_1}, {*pair.second, pair.pose_2}, {*pair.second, pair.moved_2}};
  measure_distance(contender, at, tallies);
  measure_growth(contender, at, tallies);
}

}  // namespace raygauge::bench
