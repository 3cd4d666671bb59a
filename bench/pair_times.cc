// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/pair_times.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <memory>
#include <utility>

#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"

#ifdef RAYGAUGE_HAS_FCL
#include "baselines/fcl_bodies.h"
#endif

namespace raygauge::bench {
namespace {

constexpr int kRounds = 5;  // the contenders take turns in each; the median of the rounds stands for a pair
constexpr int kCalls = 20;  // in a row, of which the mean counts
constexpr double kWrong = 1e-5;  // ten times FCL's own tolerance

using Query = std::pair<PairQuery, std::function<void()>>;

void time_in_turn(const std::vector<Query>& queries, PairTally& tally) {
  std::vector<std::function<void()>> calls;
  for (const Query& query : queries) calls.push_back(query.second);
  const std::vector<double> medians = microseconds_in_turn(calls, kRounds, kCalls);
  for (std::size_t q = 0; q < queries.size(); ++q)
    tally.microseconds[static_cast<std::size_t>(queries[q].first)].push_back(medians[q]);
}

struct Solvers {
  Solvers(double tolerance, bool general) {
    DistanceOptions options;
    options.method = DistanceMethod::newton;
    options.tolerance = tolerance;
    if (general) options.max_iterations = 100000;  // fixed-size code has no such limit and stands aside
    distance = ObjectDistanceSolver(options);
    growth = GrowthDistanceSolver(options);
  }
  ObjectDistanceSolver distance;
  GrowthDistanceSolver growth;
};

bool is_certified(const DistanceResult& r, double tolerance) {
  return r.status == DistanceStatus::contains_origin ||
         (r.status == DistanceStatus::optimal && r.upper - r.lower <= tolerance * r.upper);
}

#ifdef RAYGAUGE_HAS_FCL
struct FclPair {
  FclQuery solver[2];
};

std::unique_ptr<FclPair> fcl_pair(const PosedPair& pair) {
  const auto first = FclBody::of(*pair.first), second = FclBody::of(*pair.second);
  if (!first || !second) return nullptr;
  auto made = std::make_unique<FclPair>(
      FclPair{{FclQuery(*first, *second, FclSolver::libccd), FclQuery(*first, *second, FclSolver::indep)}});
  for (FclQuery& query : made->solver) {
    Eigen::Isometry3d at[2];
    for (int i = 0; i < 2; ++i) {
      const Pose& pose = i == 0 ? pair.pose_1 : pair.pose_2;
      at[i] = Eigen::Isometry3d::Identity();
      at[i].linear() = pose.rotation();
      at[i].translation() = pose.translation();
    }
    query.place(at[0], at[1]);
  }
  return made;
}

// False where FCL throws: it is not timed then.
bool judge_fcl(FclPair& fcl, const DistanceResult& ours, double size, PairTally& tally) {
  bool answers = true;
  ++tally.fcl_pairs;
  for (int i = 0; i < 2; ++i) {
    try {
      const double d = std::max(fcl.solver[i].distance(true), 0.0);
      const double error = std::max({0.0, d - ours.upper, ours.lower - d}) / size;
      if (error > kWrong) ++tally.wrong[i];
      tally.worst[i] = std::max(tally.worst[i], error);
      fcl.solver[i].collide();
    } catch (const std::exception&) {
      ++tally.wrong[i];
      answers = false;
    }
  }
  return answers;
}

// False where the bodies do not overlap, or FCL throws.
bool judge_fcl_depth(FclPair& fcl, const ObjectDepth& ours, double size, PairTally& tally) {
  if (ours.evaluations == 0) return false;
  ++tally.fcl_deep;
  try {
    const double depth = fcl.solver[0].penetration();
    if (!(std::max(depth - ours.upper, ours.lower - depth) <= kWrong * size)) ++tally.fcl_deep_wrong;
    return true;
  } catch (const std::exception&) {
    ++tally.fcl_deep_wrong;
    return false;
  }
}

void add_fcl_queries(FclPair& fcl, const DistanceResult& distance, const ObjectDepth& depth, double size,
                     PairTally& tally, std::vector<Query>& queries) {
  if (!judge_fcl(fcl, distance, size, tally)) return;
  queries.emplace_back(PairQuery::fcl_libccd, [&fcl] { fcl.solver[0].distance(true); });
  queries.emplace_back(PairQuery::fcl_indep, [&fcl] { fcl.solver[1].distance(true); });
  queries.emplace_back(PairQuery::fcl_collide, [&fcl] { fcl.solver[0].collide(); });
  if (judge_fcl_depth(fcl, depth, size, tally))
    queries.emplace_back(PairQuery::fcl_depth, [&fcl] { fcl.solver[0].penetration(); });
}
#endif

}  // namespace

const char* name_of(PairQuery query) {
  constexpr std::array<const char*, kPairQueries> kNames = {
      "distance", "points", "warm",   "general", "growth", "g warm",  "g general",
      "apart",    "depth",  "d warm", "libccd",  "indep",  "collide", "fcl depth"};
  return kNames[static_cast<std::size_t>(query)];
}

double PairTally::median(PairQuery query) const {
  const std::vector<double>& values = microseconds[static_cast<std::size_t>(query)];
  return values.empty() ? std::nan("") : sample_median(values);
}

namespace {

struct Places {
  Posed one, two, moved;
};

// Memory: of the warm start, and what it is before each call.
ObjectDepth add_depth_queries(ObjectDistanceSolver& solver, const Places& at, WarmStart* memory,
                              PairTally& tally, std::vector<Query>& queries) {
  static const Ball kMetric(Eigen::Vector3d::Zero(), 1);
  constexpr auto kDeep = ObjectEffects::closest_points | ObjectEffects::depth;
  ObjectDepth depth = solver.solve(at.one, at.two, kMetric, kDeep, &memory[0]).depth;
  memory[1] = memory[0];
  if (depth.evaluations > 0) {
    ++tally.deep;
    if (depth.status == DistanceStatus::optimal) ++tally.deep_certified;
  }
  queries.emplace_back(PairQuery::depth, [&solver, at] { solver.solve(at.one, at.two, kMetric, kDeep); });
  queries.emplace_back(PairQuery::depth_warm, [&solver, at, memory] {
    memory[0] = memory[1];
    solver.solve(at.one, at.moved, kMetric, kDeep, &memory[0]);
  });
  return depth;
}

}  // namespace

void measure_pair(const PosedPair& pair, double tolerance, PairTally& tally) {
  const Ball metric(Eigen::Vector3d::Zero(), 1);
  Solvers ours(tolerance, false), general(tolerance, true);
  const Posed one{*pair.first, pair.pose_1}, two{*pair.second, pair.pose_2},
      moved{*pair.second, pair.moved_2};
  constexpr auto kPoints = ObjectEffects::closest_points;
  WarmStart warm, warm_growth;
  const DistanceResult first = ours.distance.solve(one, two, metric, kPoints, &warm).distance;
  const DistanceResult first_growth = ours.growth.solve_about_centers(one, two, &warm_growth);
  ++tally.pairs;
  if (is_certified(first, tolerance) && is_certified(first_growth, tolerance)) ++tally.certified;
  const WarmStart kept = warm, kept_growth = warm_growth;
  std::vector<Query> queries = {
      {PairQuery::distance, [&] { ours.distance.solve(one, two, metric); }},
      {PairQuery::points, [&] { ours.distance.solve(one, two, metric, kPoints); }},
      {PairQuery::warm,
       [&] {
         warm = kept;
         ours.distance.solve(one, moved, metric, kPoints, &warm);
       }},
      {PairQuery::general, [&] { general.distance.solve(one, two, metric); }},
      {PairQuery::growth, [&] { ours.growth.solve_about_centers(one, two); }},
      {PairQuery::growth_warm,
       [&] {
         warm_growth = kept_growth;
         ours.growth.solve_about_centers(one, moved, &warm_growth);
       }},
      {PairQuery::growth_general, [&] { general.growth.solve_about_centers(one, two); }},
      {PairQuery::apart, [&] { ours.growth.separation(one, two); }}};
  WarmStart memory[2];
  const ObjectDepth depth = add_depth_queries(ours.distance, {one, two, moved}, memory, tally, queries);
#ifdef RAYGAUGE_HAS_FCL
  const auto fcl = fcl_pair(pair);
  if (fcl != nullptr) add_fcl_queries(*fcl, first, depth, pair.size, tally, queries);
#endif
  time_in_turn(queries, tally);
}

}  // namespace raygauge::bench
