// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_run.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "raygauge/exceptions.h"
#include "raygauge/sets/prepared_set.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_scene_run {
namespace {

using namespace random_scenes;

const Body& body_of(const Scene& scene, int number) { return scene.bodies[static_cast<std::size_t>(number)]; }

BruteForce truth_of(const Scene& scene, const SceneRecord& row) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(row.query)];
  return brute_force(body_of(scene, row.body_a), body_of(scene, row.body_b), row.time, query.metric.Q);
}

void expect_agreement(const SceneRecord& row, const BruteForce& truth) {
  EXPECT_LE(row.lower, truth.upper);
  EXPECT_LE(truth.lower, row.upper);
  EXPECT_LE(row.lower, row.distance);
  EXPECT_LE(row.distance, row.upper);
  if (row.status == SceneStatus::separated) {
    EXPECT_FALSE(truth.intersecting);
  }
  if (row.status == SceneStatus::intersecting) {
    EXPECT_EQ(truth.lower, 0.0);
  }
}

TEST(SceneRun, DistancesAreThoseOfBruteForce) {
  Random random(10);
  for (int trial = 0; trial < 60; ++trial) {
    Scene scene = random_scenes::scene(random, 2 + trial % 2, 5, 9, 2.0);
    scene.queries = {all_pairs(scene, SceneEffects::distance | SceneEffects::closest_points)};
    if (trial % 3 == 2)
      scene.queries[0].metric.Q =
          std::make_shared<Box>(-Vector::Ones(2 + trial % 2), Vector::Ones(2 + trial % 2) * 2);
    const SceneCellResult result = run(scene);
    ASSERT_EQ(result.records.size(), 90U);
    for (const SceneRecord& row : result.records) {
      expect_agreement(row, truth_of(scene, row));
      if (row.lower > 0) {
        EXPECT_LE(row.upper - row.lower, 1e-6 * row.upper);
      }
      if (row.point_a.size() > 0 && scene.queries[0].metric.euclidean()) {
        EXPECT_NEAR((row.point_a - row.point_b).norm(), row.distance, 1e-6 * row.distance + 1e-12);
      }
    }
  }
}

// Pairs that are recorded are within, and every other is beyond, at every instant.
TEST(SceneRun, WithinFindsEveryPairThatIsCloser) {
  Random random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 2 + trial % 2;
    Scene scene = random_scenes::scene(random, n, 8, 21, 3.0);
    scene.queries = {all_pairs(scene, SceneEffects::distance)};
    scene.queries[0].within = 0.3;
    if (trial % 3 == 2) scene.queries[0].metric.Q = std::make_shared<Ball>(Vector::Constant(n, 0.1), 2.0);
    const SceneCellResult result = run(scene);
    std::map<std::tuple<int, int, std::int64_t>, const SceneRecord*> rows;
    for (const SceneRecord& row : result.records) rows[{row.body_a, row.body_b, row.instant}] = &row;
    for (const BodyPair pair : pairs_of(scene, scene.queries[0])) {
      for (std::size_t k = 0; k < scene.instants.size(); ++k) {
        const BruteForce truth = brute_force(body_of(scene, pair.a), body_of(scene, pair.b),
                                             scene.instants[k], scene.queries[0].metric.Q);
        const auto found = rows.find({pair.a, pair.b, static_cast<std::int64_t>(k)});
        if (found != rows.end()) {
          expect_agreement(*found->second, truth);
          EXPECT_LE(truth.lower, 0.3 * (1 + 1e-6));
        } else {
          EXPECT_GT(truth.upper, 0.3);
        }
      }
    }
    const SceneTally& tally = result.tallies[0];
    EXPECT_EQ(tally.asked, 28 * 21);
    EXPECT_EQ(tally.solved + tally.broad_phase + tally.coherence + tally.standing, tally.asked);
  }
}

TEST(SceneRun, SeparationAgreesAtEveryInstant) {
  Random random(12);
  for (int trial = 0; trial < 60; ++trial) {
    Scene scene = random_scenes::scene(random, 2 + trial % 2, 6, 21, 2.0);
    scene.queries = {all_pairs(scene, SceneEffects::separated), all_pairs(scene, SceneEffects::separated)};
    scene.queries[0].every_instant = true;
    scene.queries[1].tolerance = 1e-5;  // solves of its own, in which only changes are recorded
    std::map<std::pair<int, int>, SceneStatus> before;
    std::map<std::tuple<int, int, std::int64_t>, SceneStatus> changes;
    const SceneCellResult result = run(scene);
    for (const SceneRecord& row : result.records) {
      if (row.query == 1) changes[{row.body_a, row.body_b, row.instant}] = row.status;
    }
    for (const SceneRecord& row : result.records) {
      if (row.query != 0) continue;
      const BruteForce truth = truth_of(scene, row);
      if (row.status == SceneStatus::separated) {
        EXPECT_GT(truth.upper, 0);
      }
      if (row.status == SceneStatus::separated) {
        EXPECT_FALSE(truth.intersecting);
      }
      if (row.status == SceneStatus::intersecting) {
        EXPECT_EQ(truth.lower, 0.0);
      }
      const auto change = changes.find({row.body_a, row.body_b, row.instant});
      SceneStatus& known = before[{row.body_a, row.body_b}];
      if (change != changes.end()) known = change->second;
      EXPECT_EQ(known, row.status);
    }
    EXPECT_EQ(result.counters.distance_solves, 0);
    EXPECT_EQ(result.counters.closest_points, 0);
    EXPECT_EQ(result.counters.growth_solves, 0);
  }
}

TEST(SceneRun, TheNearestPairsAreTheNearest) {
  Random random(13);
  for (int trial = 0; trial < 40; ++trial) {
    Scene scene = random_scenes::scene(random, 2 + trial % 2, 8, 5, 3.0);
    scene.queries = {all_pairs(scene, SceneEffects::distance)};
    scene.queries[0].nearest = 3;
    const SceneCellResult result = run(scene);
    ASSERT_EQ(result.records.size(), 15U);
    for (std::size_t k = 0; k < 5; ++k) {
      double worst = 0;
      for (const SceneRecord& row : result.records) {
        if (row.instant != static_cast<std::int64_t>(k)) continue;
        expect_agreement(row, truth_of(scene, row));
        worst = std::max(worst, row.upper);
      }
      int nearer = 0;
      for (const BodyPair pair : pairs_of(scene, scene.queries[0])) {
        const BruteForce truth =
            brute_force(body_of(scene, pair.a), body_of(scene, pair.b), scene.instants[k]);
        if (truth.upper < worst * (1 - 1e-6)) ++nearer;
      }
      EXPECT_LT(nearer, 3);
    }
  }
}

TEST(SceneRun, GrowthIsBelowOneForBodiesThatOverlapAndAboveForOthers) {
  Random random(14);
  for (int trial = 0; trial < 30; ++trial) {
    Scene scene = random_scenes::scene(random, 2 + trial % 2, 5, 7, 1.5);
    scene.queries = {all_pairs(scene, SceneEffects::growth)};
    const SceneCellResult result = run(scene);
    for (const SceneRecord& row : result.records) {
      const BruteForce truth = truth_of(scene, row);
      if (row.growth_lower > 1) {
        EXPECT_FALSE(truth.intersecting);
      }
      if (row.growth_upper < 1) {
        EXPECT_EQ(truth.lower, 0.0);
      }
      EXPECT_LE(row.growth_lower, row.growth_upper);
    }
    EXPECT_EQ(result.counters.distance_solves, 0);
    EXPECT_EQ(result.counters.separation_solves, 0);
  }
}

/// The counters of a scene that asks for these effects alone.
SceneCounters counters_of(SceneEffects effects) {
  Random random(15);
  Scene scene = random_scenes::scene(random, 3, 6, 11, 2.0);
  scene.queries = {all_pairs(scene, effects)};
  return run(scene).counters;
}

TEST(SceneRun, AnEffectThatIsNotAskedForIsNeverComputed) {
  const SceneCounters distance = counters_of(SceneEffects::distance);
  EXPECT_GT(distance.distance_solves, 0);
  EXPECT_EQ(distance.separation_solves + distance.growth_solves, 0);
  EXPECT_EQ(distance.closest_points + distance.gradients, 0);
  const SceneCounters points = counters_of(SceneEffects::closest_points);
  EXPECT_GT(points.closest_points, 0);
  EXPECT_EQ(points.gradients + points.growth_solves + points.separation_solves, 0);
  const SceneCounters gradient = counters_of(SceneEffects::gradient);
  EXPECT_GT(gradient.gradients, 0);
  EXPECT_EQ(gradient.closest_points + gradient.growth_solves + gradient.separation_solves, 0);
  const SceneCounters growth = counters_of(SceneEffects::growth);
  EXPECT_GT(growth.growth_solves, 0);
  EXPECT_EQ(growth.distance_solves + growth.separation_solves + growth.closest_points + growth.gradients, 0);
  const SceneCounters separated = counters_of(SceneEffects::separated);
  EXPECT_GT(separated.separation_solves, 0);
  EXPECT_EQ(separated.distance_solves + separated.growth_solves + separated.closest_points, 0);
  for (const SceneEffects continuous : {SceneEffects::time_of_impact, SceneEffects::clearance}) {
    const SceneCounters counters = counters_of(continuous);
    EXPECT_EQ(counters.separation_solves + counters.growth_solves + counters.gradients, 0);
  }
}

TEST(SceneRun, QueriesShareTheirSolves) {
  Random random(16);
  Scene scene = random_scenes::scene(random, 3, 6, 11, 2.0);
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  const SceneCounters alone = run(scene).counters;
  scene.queries.push_back(all_pairs(scene, SceneEffects::distance));
  scene.queries.push_back(all_pairs(scene, SceneEffects::separated));
  scene.queries[1].within = 0.5;
  const SceneCellResult together = run(scene);
  EXPECT_EQ(together.counters, alone);
  EXPECT_EQ(together.tallies[1].shared, together.tallies[1].solved);
}

TEST(SceneRun, BodiesThatStandStillAreSolvedOnce) {
  Random random(17);
  Scene scene = random_scenes::scene(random, 3, 6, 11, 2.0);
  for (Body& body : scene.bodies) body.motion = std::make_shared<StaticMotion>(placement(random, 3, 2.0));
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  const SceneCellResult result = run(scene);
  EXPECT_EQ(result.tallies[0].solved, 15);
  EXPECT_EQ(result.tallies[0].standing, 150);
}

/// All that does not depend on the clock.
std::string text_of(const SceneCellResult& result) {
  std::ostringstream text;
  text.precision(17);
  for (const SceneRecord& row : result.records) {
    text << row.query << ' ' << row.body_a << ' ' << row.body_b << ' ' << row.part_a << ' ' << row.part_b
         << ' ' << kind_text(row.kind) << ' ' << row.instant << ' ' << row.time << ' ' << row.time_lower
         << ' ' << row.time_upper << ' ' << to_string(row.status) << ' ' << to_string(row.decided) << ' '
         << row.lower << ' ' << row.upper << ' ' << row.growth_lower << ' ' << row.growth_upper << ' '
         << row.solves << ' ' << row.point_a.transpose() << ' ' << row.point_b.transpose() << ' '
         << row.gradient.transpose() << '\n';
  }
  return text.str();
}

TEST(SceneRun, ResultsAreTheSameForAnyNumberOfThreads) {
  Random random(18);
  Scene scene = random_scenes::scene(random, 3, 9, 300, 2.0);
  scene.queries = {all_pairs(scene, SceneEffects::distance | SceneEffects::closest_points),
                   all_pairs(scene, SceneEffects::separated),
                   all_pairs(scene, SceneEffects::distance | SceneEffects::gradient),
                   all_pairs(scene, SceneEffects::time_of_impact | SceneEffects::clearance)};
  scene.queries[1].tolerance = 1e-4;
  scene.queries[2].nearest = 2;
  const SceneCellResult one = run(scene, 1);
  for (const int threads : {2, 7}) {
    const SceneCellResult many = run(scene, threads);
    EXPECT_EQ(text_of(one), text_of(many)) << threads << " threads";
    EXPECT_EQ(one.counters, many.counters);
    EXPECT_EQ(one.tallies, many.tallies);
  }
}

TEST(SceneRun, ACellThatIsStoppedIsDroppedAndThoseBeforeAreWhole) {
  Random random(17);
  Scene scene = random_scenes::scene(random, 3, 5, 3000, 3.0);
  scene.queries = {all_pairs(scene, SceneEffects::distance), all_pairs(scene, SceneEffects::clearance)};
  const ScenePlan plan = plan_scene(scene);
  Collector whole;
  run_scene(scene, plan, 1, {}, whole);
  std::map<std::uint64_t, std::size_t> records;
  for (const SceneCellResult& cell : whole.cells) records[cell.cell] = cell.records.size();
  int within_cells = 0;
  for (const int most : {0, 1, 5, 20, 80, 300, 700}) {
    Collector cut;
    int asked = 0;
    SceneHooks hooks;
    hooks.stop = [&] { return ++asked > most; };
    const SceneSummary summary = run_scene(scene, plan, 1, {}, cut, hooks);
    EXPECT_EQ(summary.cells_done, cut.cells.size());
    EXPECT_EQ(summary.stopped, cut.cells.size() < plan.cells.size());
    for (const SceneCellResult& cell : cut.cells) EXPECT_EQ(cell.records.size(), records[cell.cell]);
    within_cells += asked > static_cast<int>(cut.cells.size()) + 2 ? 1 : 0;
  }
  EXPECT_GT(within_cells, 3);
}

// After a way of 2e17 a step of 1 changes no sum in double precision.
TEST(SceneRun, ABodyThatHasMovedIsNotTakenForOneThatStands) {
  std::vector<Placement> frames(4, Placement::identity(3));
  frames[1].t[0] = 1e17;
  frames[3].t[0] = 1;
  Scene scene;
  const auto ball = std::make_shared<Ball>(Vector::Zero(3), 0.1);
  const std::vector<double> times = {0, 1, 2, 3};
  scene.bodies.push_back(make_body("far", {ball}, std::make_shared<KeyframeMotion>(times, frames)));
  Placement still = Placement::identity(3);
  still.t[0] = 5;
  scene.bodies.push_back(make_body("still", {ball}, std::make_shared<StaticMotion>(still)));
  scene.instants = times;
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  const SceneCellResult result = run(scene);
  ASSERT_EQ(result.records.size(), 4U);
  EXPECT_NEAR(result.records[2].distance, 4.8, 1e-9);
  EXPECT_NEAR(result.records[3].distance, 3.8, 1e-9);
}

TEST(SceneRun, RefusesScenesThatCannotBeAnswered) {
  Random random(19);
  const Scene good = random_scenes::scene(random, 3, 3, 4, 2.0);
  Scene scene = good;
  scene.queries = {all_pairs(scene, SceneEffects::none)};
  EXPECT_THROW(plan_scene(scene), InvalidParameterError);
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  scene.queries[0].group_1 = {3};
  EXPECT_THROW(plan_scene(scene), InvalidParameterError);
  scene.queries = {all_pairs(scene, SceneEffects::clearance)};
  scene.queries[0].within = 1;
  EXPECT_THROW(plan_scene(scene), InvalidParameterError);
  scene = good;
  scene.instants = {0, 0.5, 0.5};
  EXPECT_THROW(plan_scene(scene), InvalidParameterError);
  scene.instants = {0, 2};
  scene.bodies[0].motion = std::make_shared<KeyframeMotion>(
      std::vector<double>{0, 1}, std::vector<Placement>(2, Placement::identity(3)));
  EXPECT_THROW(plan_scene(scene), InvalidParameterError);
}

TEST(SceneRun, HullsOfManyPointsArePreparedOnce) {
  Random random(5);
  Eigen::MatrixXd points(3, 1200);
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = uniform_vector(random, 3, 1.0);
  const auto fine = std::make_shared<PointSet>(points);
  const auto coarse = std::make_shared<PointSet>(points.leftCols(30));
  const Body body = make_body("stone", {fine, coarse}, motion(random, 3, 1.0));
  EXPECT_EQ(dynamic_cast<const PreparedSet*>(body.parts[0].set.get()) != nullptr, PreparedSet::has_hulls());
  EXPECT_EQ(body.parts[1].set, coarse);
  Vector u = Vector::Unit(3, 1);
  EXPECT_EQ(body.parts[0].set->support_function(u), fine->support_function(u));
}

}  // namespace
}  // namespace raygauge::test_scene_run
