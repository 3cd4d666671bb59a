// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_scenes.h"

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

namespace raygauge::soak {
namespace {

using namespace random_scenes;

constexpr int kInstants = 7;
constexpr int kWithin = 1, kNearest = 2;  // queries of draw_queries() that leave pairs out
constexpr int kMoments = 24;              // at which answers over the whole time are looked at

const Body& body_of(const Scene& scene, int number) { return scene.bodies[static_cast<std::size_t>(number)]; }

bool contradict(double lower, double upper, double true_lower, double true_upper) {
  return !(lower <= true_upper && true_lower <= upper && lower <= upper);
}

/// A query of every kind: all effects at instants, one within a distance, one for the nearest, one over time.
std::vector<SceneQuery> draw_queries(Random& random, const Scene& scene) {
  const int n = scene.dimension();
  SceneQuery all =
      all_pairs(scene, SceneEffects::distance | SceneEffects::closest_points | SceneEffects::gradient |
                           SceneEffects::growth | SceneEffects::separated);
  all.every_instant = true;
  SceneQuery within = all_pairs(scene, SceneEffects::distance);
  within.within = uniform(random, 0.05, 1.0);
  SceneQuery nearest = all_pairs(scene, SceneEffects::distance);
  nearest.nearest = 1 + static_cast<int>(random() % 3);
  SceneQuery over_time = all_pairs(scene, SceneEffects::time_of_impact | SceneEffects::clearance);
  std::vector<SceneQuery> queries = {all, within, nearest, over_time};
  if (random() % 3 == 0) {
    SceneMetric metric;
    metric.Q = std::make_shared<Box>(-Vector::Ones(n), Vector::Ones(n) * uniform(random, 1, 2));
    for (std::size_t q = 0; q < 3; ++q) queries[q].metric = metric;
  }
  return queries;
}

std::string place_of(int query, int body_a, int body_b, std::int64_t instant) {
  return "query " + std::to_string(query) + ", bodies " + std::to_string(body_a) + " and " +
         std::to_string(body_b) + ", instant " + std::to_string(instant);
}

std::string time_of_impact_error(const Scene& scene, const SceneRecord& row) {
  const Body& a = body_of(scene, row.body_a);
  const Body& b = body_of(scene, row.body_b);
  const bool contact = row.status == SceneStatus::contact;
  const double last = contact ? row.time_lower : 1;
  for (int k = 0; k <= kMoments && row.status != SceneStatus::undecided; ++k) {
    const double t = last * (k / (kMoments + 1.0));
    if (t == last) break;  // contact at the very beginning
    if (brute_force(a, b, t, nullptr, 1e-6).intersecting) return "they meet before " + std::to_string(last);
  }
  if (contact && brute_force(a, b, row.time_upper).lower > 1e-6 * (1 + 1e-6)) return "no contact";
  return "";
}

std::string clearance_error(const Scene& scene, const SceneRecord& row) {
  const Body& a = body_of(scene, row.body_a);
  const Body& b = body_of(scene, row.body_b);
  if (brute_force(a, b, row.time).lower > row.upper) return "the clearance is not attained";
  for (int k = 0; k <= kMoments; ++k) {
    const double t = k / static_cast<double>(kMoments);
    if (brute_force(a, b, t, nullptr, 1e-6).upper < row.lower) return "nearer than the clearance";
  }
  return "";
}

}  // namespace

std::string RandomScenes::instant_error(const SceneRecord& row, const BruteForce& truth) {
  if (row.status == SceneStatus::undecided) ++tally_.undecided;
  if (row.status == SceneStatus::separated && truth.intersecting) return "not separated";
  if (row.status == SceneStatus::intersecting && truth.lower > 0) return "not intersecting";
  if (row.lower == row.lower && contradict(row.lower, row.upper, truth.lower, truth.upper)) return "distance";
  if (row.growth_lower > 1 && truth.intersecting) return "growth above 1";
  if (row.growth_upper < 1 && truth.lower > 0) return "growth below 1";
  return "";
}

std::string RandomScenes::row_error(const Scene& scene, const SceneRecord& row) {
  ++tally_.records;
  if (row.kind == SceneEffects::clearance) return clearance_error(scene, row);
  if (row.kind == SceneEffects::time_of_impact) return time_of_impact_error(scene, row);
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(row.query)];
  return instant_error(
      row, brute_force(body_of(scene, row.body_a), body_of(scene, row.body_b), row.time, query.metric.Q));
}

/// Pairs that a query with a limit has left out at an instant must be beyond that limit.
std::string RandomScenes::left_out_error(const Scene& scene, const SceneCellResult& result, int q) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(q)];
  std::set<std::tuple<int, int, std::int64_t>> listed;
  std::vector<double> limits(scene.instants.size(), query.nearest > 0 ? 0 : query.within);
  for (const SceneRecord& row : result.records) {
    if (row.query != q) continue;
    listed.insert({row.body_a, row.body_b, row.instant});
    double& limit = limits[static_cast<std::size_t>(row.instant)];
    if (query.nearest > 0) limit = std::max(limit, row.upper * (1 - 1e-6));
  }
  for (const BodyPair pair : pairs_of(scene, query)) {
    for (std::size_t k = 0; k < scene.instants.size(); ++k) {
      if (listed.count({pair.a, pair.b, static_cast<std::int64_t>(k)}) > 0) continue;
      ++tally_.left_out;
      const BruteForce truth =
          brute_force(body_of(scene, pair.a), body_of(scene, pair.b), scene.instants[k], query.metric.Q);
      if (truth.upper < limits[k]) {
        return place_of(q, pair.a, pair.b, static_cast<std::int64_t>(k)) + ": left out";
      }
    }
  }
  return "";
}

std::string RandomScenes::compare(const Scene& scene, const SceneCellResult& result) {
  for (const SceneRecord& row : result.records) {
    const std::string error = row_error(scene, row);
    if (!error.empty()) return place_of(row.query, row.body_a, row.body_b, row.instant) + ": " + error;
  }
  const std::string of_within = left_out_error(scene, result, kWithin);
  return of_within.empty() ? left_out_error(scene, result, kNearest) : of_within;
}

std::optional<std::string> RandomScenes::check(std::int64_t number) {
  Random random(seed_ * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(number));
  const int n = 2 + static_cast<int>(random() % 2);
  const int bodies = 3 + static_cast<int>(random() % 4);
  Scene scene = random_scenes::scene(random, n, bodies, kInstants, uniform(random, 1.0, 4.0));
  scene.queries = draw_queries(random, scene);
  const std::string wrong = compare(scene, run(scene));
  ++tally_.scenes;
  if (wrong.empty()) return std::nullopt;
  return "scene " + std::to_string(number) + " in R^" + std::to_string(n) + ", " + wrong;
}

std::string to_string(const SceneSoakTally& tally) {
  return std::to_string(tally.scenes) + " scenes, " + std::to_string(tally.records) + " answers, " +
         std::to_string(tally.left_out) + " left out by within or nearest, " +
         std::to_string(tally.undecided) + " undecided\n";
}

}  // namespace raygauge::soak
