// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Half-spaces as bodies of scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/sets/half_space.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_scene_half_space {
namespace {

using namespace random_scenes;

SetPointer half_space(const Vector& normal, double offset) {
  return std::make_shared<HalfSpace>(normal, offset);
}

Body floor_at(double height, MotionPointer motion = nullptr) {
  if (motion == nullptr) motion = std::make_shared<StaticMotion>(Placement::identity(3));
  return make_body("floor", {half_space(Eigen::Vector3d(0, 0, 2), 2 * height)}, std::move(motion));
}

MotionPointer falls(const Vector& from, const Eigen::Vector3d& spin, double velocity = 0) {
  Placement start = Placement::identity(3);
  start.t = from;
  TwistMotion::Rates rates;
  rates.velocity = Eigen::Vector3d(0.3, 0, velocity);
  rates.acceleration = Eigen::Vector3d(0, 0, -10);
  rates.spin = spin;
  return std::make_shared<TwistMotion>(start, rates, 0.0);
}

std::vector<double> instants(int count, double to) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(to * k / (count - 1));
  return times;
}

TEST(SceneHalfSpace, IsMetByAFallingBallWhenItsHeightIsItsRadius) {
  Scene scene;
  scene.bodies = {floor_at(0.5), make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), 0.5)},
                                           falls(Eigen::Vector3d(0, 0, 6), Eigen::Vector3d(3, 1, 2)))};
  scene.instants = instants(21, 2);
  scene.queries = {
      all_pairs(scene, SceneEffects::depth | SceneEffects::time_of_impact | SceneEffects::clearance)};
  for (const SceneRecord& row : run(scene).records) {
    if (row.kind == SceneEffects::time_of_impact) {
      EXPECT_EQ(row.status, SceneStatus::contact);
      EXPECT_LE(row.time_lower, 1);
      EXPECT_NEAR(row.time_upper, 1, 1e-6);
      EXPECT_LE(row.time_upper - row.time_lower, 1e-6);
    } else if (row.kind == SceneEffects::clearance) {
      EXPECT_EQ(row.status, SceneStatus::intersecting);
      EXPECT_NEAR(row.time, 1, 1e-6);
    } else {
      const double height = 5 - 5 * row.time * row.time;
      EXPECT_NEAR(row.signed_distance(), height, 1e-9);
      EXPECT_LE(row.signed_lower(), height + 1e-13);
      EXPECT_GE(row.signed_upper(), height - 1e-13);
      EXPECT_NEAR(row.gradient[2], -1, 1e-12) << "body a is the floor";
      EXPECT_NEAR(row.point_a[2], 0.5, 1e-9);
    }
  }
}

/// The box that the shipped scenes had before: no near body tells it from the floor.
Body large_box(double height) {
  const Eigen::Vector3d lower(-500, -500, height - 500), upper(500, 500, height);
  return make_body("box", {std::make_shared<Box>(lower, upper)},
                   std::make_shared<StaticMotion>(Placement::identity(3)));
}

TEST(SceneHalfSpace, AgreesWithALargeBoxOnTheWay) {
  Random random(41);
  int contacts = 0, clear = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Scene scene = random_scenes::scene(random, 3, 4, 9, 1.5);
    const double height = uniform(random, -3, -0.5);
    const auto ask = [&](const Body& below) {
      Scene with = scene;
      with.bodies.push_back(below);
      SceneQuery query = all_pairs(with, SceneEffects::distance | SceneEffects::closest_points |
                                             SceneEffects::time_of_impact | SceneEffects::clearance);
      query.group_1 = {0, 1, 2, 3};
      query.group_2 = {4};
      with.queries = {query};
      return run(with).records;
    };
    const auto known = ask(floor_at(height)), other = ask(large_box(height));
    ASSERT_EQ(known.size(), other.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      const SceneRecord &x = known[i], &y = other[i];
      ASSERT_EQ(x.kind, y.kind);
      if (x.kind == SceneEffects::time_of_impact) {
        EXPECT_EQ(x.status, y.status);
        if (x.status != SceneStatus::contact) continue;
        ++contacts;
        EXPECT_LE(y.time_lower, x.time_upper + 1e-9);
        const Body &body = scene.bodies[static_cast<std::size_t>(x.body_a)], below = large_box(height);
        EXPECT_LE(brute_force(body, below, x.time_upper).lower, 1e-6)
            << "the distance that counts as a contact";
        for (int k = 0; k < 32 && x.time_lower > 0; ++k)
          EXPECT_FALSE(brute_force(body, below, x.time_lower * k / 32).intersecting);
      } else {
        EXPECT_LE(x.lower, y.upper + 1e-11);
        EXPECT_LE(y.lower, x.upper + 1e-11);
        if (x.kind == SceneEffects::clearance && x.lower > 0) {
          ++clear;
          EXPECT_LE(x.upper - x.lower, 1e-3 * x.upper);
        }
        if (x.kind == SceneEffects::none && x.lower > 0) {
          EXPECT_LE(x.upper - x.lower, 1e-6 * x.upper);
          EXPECT_NEAR((x.point_a - x.point_b).norm(), x.distance, 1e-9);
        }
      }
    }
  }
  EXPECT_GT(contacts, 20);
  EXPECT_GT(clear, 20);
}

TEST(SceneHalfSpace, MayRise) {
  Scene scene;
  TwistMotion::Rates up;
  up.velocity = Eigen::Vector3d(0, 0, 1);
  up.acceleration = Eigen::Vector3d::Zero();
  scene.bodies = {floor_at(0, std::make_shared<TwistMotion>(Placement::identity(3), up, 0.0)),
                  make_body("ball", {std::make_shared<Ball>(Eigen::Vector3d(0, 0, 2), 0.5)},
                            std::make_shared<StaticMotion>(Placement::identity(3)))};
  scene.instants = instants(21, 2);
  scene.queries = {all_pairs(scene, SceneEffects::time_of_impact), all_pairs(scene, SceneEffects::distance)};
  scene.queries[1].within = 0.25;
  for (const SceneRecord& row : run(scene).records) {
    if (row.kind == SceneEffects::time_of_impact) {
      EXPECT_NEAR(row.time_upper, 1.5, 1e-6);
    } else {
      EXPECT_GE(row.time, 1.25 - 1e-9);
    }
  }
}

TEST(SceneHalfSpace, IsLeftAloneWhileItsPlaneProvesThatABodyIsFar) {
  Scene scene;
  scene.bodies = {
      floor_at(0),
      make_body("box",
                {std::make_shared<Box>(Eigen::Vector3d(-0.3, -0.2, -0.1), Eigen::Vector3d(0.3, 0.2, 0.1))},
                falls(Eigen::Vector3d(0, 0, 40), Eigen::Vector3d(9, 14, 5)))};
  scene.instants = instants(1001, 2);
  scene.queries = {all_pairs(scene, SceneEffects::separated)};
  const SceneCellResult result = run(scene);
  EXPECT_LT(result.counters.separation_solves, 20);
  EXPECT_EQ(result.records.size(), 1U);
}

TEST(SceneHalfSpace, MayBeTiltedAndTurnAtInstants) {
  Placement tilted = Placement::identity(2);
  tilted.R = plane_rotation(0.5);
  tilted.t = Eigen::Vector2d(0, 1);
  Scene scene;
  const SetPointer line = half_space(Eigen::Vector2d(0, 1), 0);
  scene.bodies = {
      make_body("slope", {line},
                std::make_shared<KeyframeMotion>(std::vector<double>{0, 1},
                                                 std::vector<Placement>{Placement::identity(2), tilted})),
      make_body("ball", {std::make_shared<Ball>(Eigen::Vector2d(3, 5), 1)},
                std::make_shared<StaticMotion>(Placement::identity(2)))};
  scene.instants = {0, 0.5, 1};
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  for (const SceneRecord& row : run(scene).records) {
    const double angle = 0.5 * row.time;
    const Eigen::Vector2d normal(-std::sin(angle), std::cos(angle));
    EXPECT_NEAR(row.distance, normal.dot(Eigen::Vector2d(3, 5 - row.time)) - 1, 1e-12);
  }
  scene.queries[0].effects = SceneEffects::clearance;
  EXPECT_THROW(check_scene(scene), InvalidParameterError);
}

std::string refusal(const Scene& scene) {
  try {
    check_scene(scene);
  } catch (const InvalidParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneHalfSpace, IsRefusedWhereItMeansNothing) {
  Scene scene;
  scene.bodies = {floor_at(0), floor_at(1),
                  make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), 1)},
                            std::make_shared<StaticMotion>(Placement::identity(3)))};
  scene.bodies[1].name = "other";
  scene.instants = {0};
  scene.queries = {all_pairs(scene, SceneEffects::distance)};
  EXPECT_NE(refusal(scene).find("body 'floor' is a half-space, and so is body 'other'"), std::string::npos);
  scene.ignored = {{0, 1}};
  EXPECT_EQ(refusal(scene), "");
  scene.queries[0].effects = SceneEffects::growth;
  EXPECT_NE(refusal(scene).find("no centre"), std::string::npos) << refusal(scene);
  scene.queries[0].effects = SceneEffects::distance;
  scene.queries[0].metric.Q = half_space(Eigen::Vector3d(0, 0, 1), 0);
  EXPECT_NE(refusal(scene).find("not bounded"), std::string::npos);
  EXPECT_THROW(
      make_body("both", {half_space(Eigen::Vector3d(0, 0, 1), 0), std::make_shared<Ball>(Vector::Zero(3), 1)},
                std::make_shared<StaticMotion>(Placement::identity(3))),
      InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_scene_half_space
