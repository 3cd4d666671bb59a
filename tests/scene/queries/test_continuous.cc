// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/continuous.h"

#include <gtest/gtest.h>

#include "tests/scene/random_scenes.h"

namespace raygauge::test_continuous {
namespace {

using namespace random_scenes;

ContinuousOptions over(double from, double to) {
  ContinuousOptions options;
  options.from = from;
  options.to = to;
  return options;
}

MotionPointer standing(const SmallVector& t) {
  Placement where = Placement::identity(static_cast<int>(t.size()));
  where.t = t;
  return std::make_shared<StaticMotion>(where);
}

MotionPointer flying(const SmallVector& t, const SmallVector& velocity, const Eigen::Vector3d& spin) {
  Placement where = Placement::identity(static_cast<int>(t.size()));
  where.t = t;
  TwistMotion::Rates rates;
  rates.velocity = velocity;
  rates.spin = spin;
  return std::make_shared<TwistMotion>(where, rates, 0.0);
}

SmallVector vector3(double x, double y, double z) {
  SmallVector v(3);
  v << x, y, z;
  return v;
}

TEST(TimeOfImpact, TwoBallsMeetWhenTheirRadiiSay) {
  const auto ball = std::make_shared<Ball>(Vector::Zero(3), 1.0);
  const Body still = make_body("still", {ball}, standing(vector3(0, 0, 0)));
  const Body moving = make_body("moving", {ball}, flying(vector3(10, 0, 0), vector3(-4, 0, 0), {3, 5, 7}));
  ContinuousSolver solver(3);
  const ImpactResult impact = solver.time_of_impact(still, moving, over(0, 5));
  ASSERT_EQ(impact.outcome, ImpactResult::Outcome::contact);
  EXPECT_LE(impact.lower, 2.0);
  EXPECT_GE(impact.lower, 2.0 - 1e-6);
  EXPECT_NEAR(impact.upper, 2.0, 1e-6);
  EXPECT_LE(impact.steps, 3);  // a ball that turns about its centre is the same ball
  EXPECT_EQ(solver.time_of_impact(still, moving, over(0, 1.9)).outcome, ImpactResult::Outcome::free);
}

// A rod that turns once a second sweeps a circle of its half length: what is beyond is never met, what is
// within is met when the rod points at it.
TEST(TimeOfImpact, ASpinningRodMeetsWhatItsTipReaches) {
  const auto rod = std::make_shared<Box>(Eigen::Vector3d(-1, -0.01, -0.01), Eigen::Vector3d(1, 0.01, 0.01));
  const auto ball = std::make_shared<Ball>(Vector::Zero(3), 0.1);
  const Body turning =
      make_body("rod", {rod}, flying(vector3(0, 0, 0), vector3(0, 0, 0), {0, 0, 2 * EIGEN_PI}));
  ContinuousSolver solver(3);
  const Body beyond = make_body("beyond", {ball}, standing(vector3(0, 1.1002, 0)));
  EXPECT_EQ(solver.time_of_impact(turning, beyond, over(0, 10)).outcome, ImpactResult::Outcome::free);
  const Body within = make_body("within", {ball}, standing(vector3(0, 1.05, 0)));
  const ImpactResult impact = solver.time_of_impact(turning, within, over(0, 10));
  ASSERT_EQ(impact.outcome, ImpactResult::Outcome::contact);
  EXPECT_GT(impact.lower, 0.2);
  EXPECT_LT(impact.upper, 0.25);
}

// The face of a turning box is a plane that turns: planes that stand still come nearer by a tenth a step
// only.
TEST(TimeOfImpact, ATurningFaceIsMetInFewSteps) {
  const auto box = std::make_shared<Box>(Eigen::Vector3d(-1, -1, -0.1), Eigen::Vector3d(1, 1, 0.1));
  const auto ball = std::make_shared<Ball>(Vector::Zero(3), 0.1);
  Random random(19);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int contacts = 0;
  std::int64_t steps = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d spin(2 * uniform(random), 2 * uniform(random), 2 * uniform(random));
    const Body turning = make_body("box", {box}, flying(vector3(0, 0, 0), vector3(0, 0, 0), spin));
    const SmallVector start = vector3(uniform(random), uniform(random), 3);
    const Body falling = make_body("ball", {ball}, flying(start, vector3(0, 0, -6), {0, 0, 0}));
    ContinuousSolver solver(3);
    ContinuousOptions closely = over(0, 1);
    closely.contact = 1e-11;
    const ImpactResult impact = solver.time_of_impact(turning, falling, closely);
    ASSERT_NE(impact.outcome, ImpactResult::Outcome::undecided);
    if (impact.outcome == ImpactResult::Outcome::free) continue;
    ++contacts;
    steps += impact.steps;
    const double before = impact.lower - 1e-6;
    EXPECT_GT(brute_force(turning, falling, before).lower, 0);
  }
  EXPECT_GT(contacts, 100);
  EXPECT_LT(static_cast<double>(steps) / contacts, 10);  // 7.5; with planes that stand still 27
}

/// The first of `steps` moments at which exact tests do not find the bodies apart by more than the contact
/// distance; the end where there is none.
double first_seen(const Body& a, const Body& b, double contact, int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    if (brute_force(a, b, t, nullptr, 1e-6).lower <= contact * (1 - 1e-3)) return t;
  }
  return std::numeric_limits<double>::infinity();
}

TEST(TimeOfImpact, NothingIsMetBeforeItsLowerBoundAndSomethingAtItsUpper) {
  Random random(20);
  int contacts = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 2 + trial % 2;
    const Scene scene = random_scenes::scene(random, n, 2, 2, 1.5);
    ContinuousSolver solver(n);
    ContinuousOptions options = over(0, 1);
    options.contact = 1e-5;
    const ImpactResult impact = solver.time_of_impact(scene.bodies[0], scene.bodies[1], options);
    const double seen = first_seen(scene.bodies[0], scene.bodies[1], options.contact, 200);
    if (impact.outcome == ImpactResult::Outcome::contact) {
      ++contacts;
      EXPECT_LE(impact.lower, seen);
      EXPECT_LE(brute_force(scene.bodies[0], scene.bodies[1], impact.upper).lower, options.contact);
      EXPECT_LE(impact.lower, impact.upper);
    } else {
      ASSERT_EQ(impact.outcome, ImpactResult::Outcome::free) << trial;
      EXPECT_EQ(seen, std::numeric_limits<double>::infinity()) << trial;
    }
  }
  EXPECT_GT(contacts, 100);
  EXPECT_LT(contacts, 390);
}

// Of two bodies of several parts, the answers are about the two parts that meet, or come nearest, at that
// time.
TEST(Continuous, AnswersNameTheNearestParts) {
  Random random(23);
  int contacts = 0, second_parts = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 2 + trial % 2;
    const Scene scene = random_scenes::scene(random, n, 2, 3, 1.5);
    const Body &a = scene.bodies[0], &b = scene.bodies[1];
    const auto apart = [&](double t, const PairAnswer& answer) {
      const auto part = [](const Body& body, int number) {
        return make_body("part", {body.parts.at(static_cast<std::size_t>(number)).set}, body.motion);
      };
      return brute_force(part(a, answer.part_a), part(b, answer.part_b), t).lower;
    };
    ContinuousSolver solver(n);
    const ImpactResult impact = solver.time_of_impact(a, b, over(0, 1));
    if (impact.outcome == ImpactResult::Outcome::contact) {
      ++contacts;
      EXPECT_LE(apart(impact.upper, impact.at_upper), 1e-6) << trial;
      second_parts += impact.at_upper.part_a + impact.at_upper.part_b > 0 ? 1 : 0;
    } else {
      EXPECT_EQ(impact.at_upper.part_a, -1) << "there is none";
    }
    const ClearanceResult found = solver.clearance(a, b, SceneMetric(), nullptr, over(0, 1));
    EXPECT_LE(apart(found.time, found.at_time), found.upper * (1 + 1e-6) + 1e-9) << trial;
  }
  EXPECT_GT(contacts, 20);
  EXPECT_GT(second_parts, 10);
}

TEST(Clearance, NoMomentIsBelowItAndOneAttainsIt) {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 2 + trial % 2;
    const Scene scene = random_scenes::scene(random, n, 2, 2, 3.0);
    ContinuousSolver solver(n);
    SceneMetric metric;
    if (trial % 4 == 3) metric.Q = std::make_shared<Box>(-Vector::Ones(n), 3 * Vector::Ones(n));
    const ClearanceResult found =
        solver.clearance(scene.bodies[0], scene.bodies[1], metric, nullptr, over(0, 1));
    const BruteForce there = brute_force(scene.bodies[0], scene.bodies[1], found.time, metric.Q);
    EXPECT_LE(there.lower, found.upper);
    EXPECT_LE(found.lower, found.upper);
    if (found.upper > 1e-6) {
      EXPECT_LE(found.upper - found.lower, 1e-3 * found.upper) << trial;
    }
    for (int k = 0; k <= 100; ++k) {
      EXPECT_LE(found.lower, brute_force(scene.bodies[0], scene.bodies[1], k / 100.0, metric.Q).upper);
    }
  }
}

TEST(Clearance, AMetricMayFollowABody) {
  Random random(22);
  for (int trial = 0; trial < 50; ++trial) {
    const Scene scene = random_scenes::scene(random, 3, 2, 2, 3.0);
    SceneMetric metric;
    metric.Q = std::make_shared<Box>(Eigen::Vector3d(-1, -2, -3), Eigen::Vector3d(2, 1, 1));
    metric.body = 0;
    ContinuousSolver solver(3);
    const ClearanceResult found =
        solver.clearance(scene.bodies[0], scene.bodies[1], metric, &scene.bodies[0], over(0, 1));
    for (int k = 0; k <= 50; ++k) {
      const double t = k / 50.0;
      const Pose turned(scene.bodies[0].motion->at(t).R, Vector::Zero(3));
      const auto Q = std::make_shared<PosedView>(*metric.Q, turned);
      EXPECT_LE(found.lower, brute_force(scene.bodies[0], scene.bodies[1], t, Q).upper);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_continuous
