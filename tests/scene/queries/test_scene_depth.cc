// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The effect `depth`: signed distances at instants.
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/queries/growth_distance.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_scene_depth {
namespace {

using namespace random_scenes;

MotionPointer flies(const Vector& from, const Vector& velocity) {
  Placement start = Placement::identity(static_cast<int>(from.size()));
  start.t = from;
  TwistMotion::Rates rates;
  rates.velocity = velocity;
  rates.acceleration = Vector::Zero(from.size());
  if (from.size() == 3) rates.spin = Vector::Zero(3);
  return std::make_shared<TwistMotion>(start, rates, 0.0);
}

MotionPointer stands(int n) { return std::make_shared<StaticMotion>(Placement::identity(n)); }

Body ball(const std::string& name, double radius, const MotionPointer& motion) {
  return make_body(name, {std::make_shared<Ball>(Vector::Zero(motion->dimension()), radius)}, motion);
}

/// A ball of radius 0.75 flies over one of radius 0.5 at a height of 0.25.
Scene passing_balls() {
  Scene scene;
  scene.bodies = {ball("one", 0.75, flies(Eigen::Vector3d(-2, 0, 0.25), Eigen::Vector3d(4, 0, 0))),
                  ball("other", 0.5, stands(3))};
  for (int k = 0; k <= 40; ++k) scene.instants.push_back(k / 40.0);
  scene.queries = {all_pairs(scene, SceneEffects::depth)};
  return scene;
}

TEST(SceneDepth, OfTwoBallsIsTheirRadiiLessTheWayBetweenTheirCentres) {
  const SceneCellResult result = run(passing_balls());
  ASSERT_EQ(result.records.size(), 41U);
  for (const SceneRecord& row : result.records) {
    const Eigen::Vector3d center(-2 + 4 * row.time, 0, 0.25);
    const double gap = center.norm() - 1.25;
    EXPECT_EQ(row.status, gap > 0 ? SceneStatus::separated : SceneStatus::intersecting);
    EXPECT_NEAR(row.signed_distance(), gap, 1e-6 * std::fabs(gap));
    EXPECT_LE(row.signed_lower(), gap + 1e-15);
    EXPECT_GE(row.signed_upper(), gap - 1e-15);
    ASSERT_EQ(row.gradient.size(), 3);
    EXPECT_LE((row.gradient - center.normalized()).norm(), 1e-6);
    EXPECT_LE((row.point_a - (center - 0.75 * center.normalized())).norm(), 1e-6);
    EXPECT_LE((row.point_b - 0.5 * center.normalized()).norm(), 1e-6);
    if (gap > 0) {
      EXPECT_EQ(row.depth_upper, 0);
    } else {
      EXPECT_LE(row.depth_upper - row.depth_lower, 1e-6 * row.depth_upper);
      EXPECT_EQ(row.distance, 0);
    }
  }
}

Separation separation_after(const Scene& scene, const SceneRecord& row, const Vector& way) {
  const Body &a = scene.bodies[static_cast<std::size_t>(row.body_a)],
             &b = scene.bodies[static_cast<std::size_t>(row.body_b)];
  const Placement at_a = a.motion->at(row.time), at_b = b.motion->at(row.time);
  const Pose pose_a(at_a.R, at_a.t + way), pose_b(at_b.R, at_b.t);
  GrowthDistanceSolver solver;
  Separation least = Separation::separated;
  for (const BodyPart& part_a : a.parts) {
    for (const BodyPart& part_b : b.parts) {
      const Separation found = solver.separation({*part_a.set, pose_a}, {*part_b.set, pose_b}).outcome;
      if (found != Separation::separated) least = found;
    }
  }
  return least;
}

TEST(SceneDepth, IsTheShortestWayOut) {
  Random random(31);
  int overlaps = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 2 + trial % 2;
    Scene scene = random_scenes::scene(random, n, 4, 5, 0.8);
    scene.queries = {all_pairs(scene, SceneEffects::depth)};
    for (const SceneRecord& row : run(scene).records) {
      const BruteForce truth = brute_force(scene.bodies[static_cast<std::size_t>(row.body_a)],
                                           scene.bodies[static_cast<std::size_t>(row.body_b)], row.time);
      EXPECT_LE(row.lower, truth.upper);
      EXPECT_GE(row.upper, truth.lower);
      if (!(row.depth_lower > 1e-6)) continue;
      ++overlaps;
      EXPECT_EQ(row.status, SceneStatus::intersecting);
      EXPECT_TRUE(truth.intersecting);
      EXPECT_LE(row.depth_upper - row.depth_lower, 1e-6 * row.depth_upper);
      const SmallVector way = row.point_b - row.point_a;
      const double gap = 1e-6 * row.depth, size = 4;  // curved faces leave √(gap · size) across the normal
      EXPECT_NEAR(way.dot(row.gradient), row.depth, 2 * gap + 1e-12);
      EXPECT_LE((way - row.depth * row.gradient).norm(), 2 * std::sqrt(gap * size));
      const bool convex = scene.bodies[static_cast<std::size_t>(row.body_a)].parts.size() == 1 &&
                          scene.bodies[static_cast<std::size_t>(row.body_b)].parts.size() == 1;
      if (convex) {
        EXPECT_EQ(separation_after(scene, row, row.gradient * (row.depth_upper * (1 + 1e-5) + 1e-9)),
                  Separation::separated);
      }
      for (int i = 0; i < 6; ++i) {
        const Vector out = i == 0 ? Vector(row.gradient) : Vector(uniform_vector(random, n, 1));
        EXPECT_NE(separation_after(scene, row, out.normalized() * (row.depth_lower * (1 - 1e-5))),
                  Separation::separated);
      }
    }
  }
  EXPECT_GT(overlaps, 300);
}

TEST(SceneDepth, FollowsTheMetricOfTheQuery) {
  Scene scene = passing_balls();
  scene.instants = {0.5};
  scene.queries[0].metric.Q =
      std::make_shared<Box>(Eigen::Vector3d(-1, -1, -0.125), Eigen::Vector3d(1, 1, 0.125));
  const SceneRecord row = run(scene).records.front();
  // h_D(u) / h_Q(u) with D a ball of radius 1.25 about (0, 0, -0.25): sideways it is |(1, 0.25, 0)| or more.
  EXPECT_LE(row.depth_lower, std::hypot(1.25, 0) + 1e-9);
  EXPECT_GT(row.depth_lower, 0.8);
  const Eigen::Vector3d u(row.gradient);
  const double height = 1.25 * u.norm() - 0.25 * u.z();
  EXPECT_NEAR(height, row.depth_upper, 1e-5);
  EXPECT_NEAR(u.lpNorm<1>() - 0.875 * std::fabs(u.z()), 1, 1e-9);
}

TEST(SceneDepth, OfSeveralPartsIsThatOfTheDeepest) {
  Scene scene;
  const auto at = [](double x, double radius) {
    return std::make_shared<Ball>(Eigen::Vector2d(x, 0), radius);
  };
  scene.bodies = {make_body("two", {at(-1, 1), at(1.2, 1), at(30, 1)}, stands(2)),
                  ball("one", 0.5, stands(2))};
  scene.instants = {0};
  scene.queries = {all_pairs(scene, SceneEffects::depth)};
  const SceneCellResult result = run(scene);
  const SceneRecord& row = result.records.front();
  EXPECT_NEAR(row.depth, 0.5, 1e-6);
  EXPECT_EQ(row.part_a, 0);
  EXPECT_LT((row.gradient - Eigen::Vector2d(-1, 0)).norm(), 1e-6);
  EXPECT_EQ(result.counters.depths, 2) << "the third is proven to be apart by its bounding ball";
}

TEST(SceneDepth, IsNotComputedWhereNobodyAsksForIt) {
  Random random(32);
  Scene scene = random_scenes::scene(random, 3, 6, 11, 0.8);
  scene.queries = {all_pairs(scene, SceneEffects::separated | SceneEffects::distance |
                                        SceneEffects::closest_points | SceneEffects::gradient |
                                        SceneEffects::growth | SceneEffects::clearance)};
  const SceneCellResult without = run(scene);
  EXPECT_EQ(without.counters.depths, 0);
  for (const SceneRecord& row : without.records) EXPECT_TRUE(std::isnan(row.depth));
  scene.queries = {all_pairs(scene, SceneEffects::depth)};
  const SceneCellResult with = run(scene);
  EXPECT_GT(with.counters.depths, 0);
  EXPECT_EQ(with.counters.growth_solves + with.counters.separation_solves, 0);
  for (const SceneRecord& row : with.records) EXPECT_FALSE(std::isnan(row.depth));
}

TEST(SceneDepth, OfBodiesThatAreApartCostsNoDepth) {
  Scene scene = passing_balls();
  scene.instants = {0, 0.05};
  const SceneCellResult result = run(scene);
  EXPECT_EQ(result.counters.depths, 0);
  EXPECT_EQ(result.records.front().depth_upper, 0);
}

TEST(SceneDepth, ServesTheQueriesThatShareItsSolves) {
  Scene scene = passing_balls();
  scene.queries.push_back(all_pairs(scene, SceneEffects::distance));
  scene.queries.push_back(all_pairs(scene, SceneEffects::closest_points | SceneEffects::gradient));
  scene.queries.push_back(all_pairs(scene, SceneEffects::depth));
  scene.queries[3].within = 0.1;
  const SceneCellResult result = run(scene);
  EXPECT_EQ(result.counters.distance_solves, 41);
  for (const SceneRecord& row : result.records) {
    const bool points = row.query == 0 || row.query == 3 || (row.query == 2 && row.lower > 0);
    EXPECT_EQ(row.point_a.size() > 0, points);
    EXPECT_EQ(row.gradient.size() > 0, points);
    EXPECT_EQ(std::isnan(row.depth), row.query == 1 || row.query == 2);
    if (row.query == 3) {
      EXPECT_LE(row.lower, 0.1);
    }
  }
}

TEST(SceneDepth, PutsTheDeepestPairFirst) {
  Scene scene;
  scene.bodies = {ball("at", 1, stands(2)),
                  ball("by 1", 1, flies(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0))),
                  ball("by 0.5", 1, flies(Eigen::Vector2d(-0.5, 0), Eigen::Vector2d(0, 0)))};
  scene.instants = {0};
  scene.queries = {all_pairs(scene, SceneEffects::depth)};
  scene.queries[0].nearest = 1;
  const SceneCellResult result = run(scene);
  ASSERT_EQ(result.records.size(), 1U);
  EXPECT_EQ(result.records[0].body_b, 2);
  EXPECT_NEAR(result.records[0].depth, 1.5, 1e-6);
}

TEST(SceneDepth, InFourDimensionsHasBoundsThatHold) {
  Scene scene;
  scene.bodies = {ball("a", 1, stands(4)), ball("b", 1, flies(Vector::Unit(4, 2), Vector::Zero(4)))};
  scene.instants = {0};
  scene.queries = {all_pairs(scene, SceneEffects::depth)};
  const SceneRecord row = run(scene).records.front();
  EXPECT_EQ(row.status, SceneStatus::intersecting);
  EXPECT_LE(row.depth_lower, 1);
  EXPECT_GE(row.depth_upper, 1);
  EXPECT_EQ(row.signed_lower(), -row.depth_upper);
}

}  // namespace
}  // namespace raygauge::test_scene_depth
