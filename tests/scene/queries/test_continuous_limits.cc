// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "raygauge/numerics/quad.h"
#include "raygauge/scene/continuous.h"
#include "raygauge/scene/motion.h"
#include "tests/scene/random_scenes.h"

// Times of impact and clearances where rounding, overflow or a gap that hardly changes decides.
namespace raygauge::test_continuous_limits {
namespace {

using namespace random_scenes;
using Outcome = ImpactResult::Outcome;

const SceneMetric kEuclidean;

Placement at_x(double x) {
  Placement where = Placement::identity(3);
  where.t[0] = x;
  return where;
}

Body ball_on(MotionPointer motion, double radius = 0.5) {
  return make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), radius)}, std::move(motion));
}

/// [lower, upper] × [-3, 3]².
Body wall(double lower, double upper) {
  const auto box = std::make_shared<Box>(Eigen::Vector3d(lower, -3, -3), Eigen::Vector3d(upper, 3, 3));
  return make_body("wall", {box}, std::make_shared<StaticMotion>(Placement::identity(3)));
}

MotionPointer along_x(const std::vector<double>& times, const std::vector<double>& x) {
  std::vector<Placement> frames;
  for (const double value : x) frames.push_back(at_x(value));
  return std::make_shared<KeyframeMotion>(times, frames);
}

ContinuousOptions until(double to, double contact = 1e-6) {
  ContinuousOptions options;
  options.to = to;
  options.contact = contact;
  options.max_steps = 20'000;
  return options;
}

// x0 + v t + a t²/2 is farthest at x0 - v²/2a. All terms are far larger than what decides.
TEST(Continuous, ABodyThatComesToRestIsJudgedByWhereItRests) {
  Random random(41);
  int decided = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double far = std::pow(10.0, uniform(random, 0, 8)), rest = std::pow(10.0, uniform(random, -2, 1));
    TwistMotion::Rates rates;
    rates.velocity = Eigen::Vector3d(2 * far / rest, 0, 0);
    rates.acceleration = Eigen::Vector3d(-2 * far / (rest * rest), 0, 0);
    const double x0 = -far;
    const Quad v = rates.velocity[0], a = rates.acceleration[0];
    const Quad farthest = x0 - v * v / (2 * a);
    const double wanted = far * std::pow(10.0, uniform(random, -20, -9)) * (trial % 2 == 0 ? 1 : -1);
    const auto face = static_cast<double>(farthest + 0.5 + wanted);
    const auto gap = static_cast<double>(face - Quad(0.5) - farthest);
    if (gap == 0) continue;
    const Body ball = ball_on(std::make_shared<TwistMotion>(at_x(x0), rates, 0.0));
    const Body target = wall(face, face + 1);
    const ContinuousOptions options = until(2 * rest, std::max(1e-300, 1e-3 * std::fabs(gap)));
    ContinuousSolver solver(3);
    const ImpactResult impact = solver.time_of_impact(ball, target, options);
    const ClearanceResult found = solver.clearance(ball, target, kEuclidean, nullptr, options);
    EXPECT_NE(impact.outcome, gap > 0 ? Outcome::contact : Outcome::free) << trial << " " << gap;
    EXPECT_LE(found.lower, std::max(0.0, gap)) << trial;
    EXPECT_GE(found.upper, std::max(0.0, gap)) << trial;
    EXPECT_TRUE(gap < 0 || !found.touches) << trial;
    decided += impact.outcome != Outcome::undecided ? 1 : 0;
    if (gap < -1e-12) {
      EXPECT_EQ(impact.outcome, Outcome::contact) << trial << " " << gap;
    }
  }
  EXPECT_GT(decided, 200);
}

TEST(Continuous, ABallThatPassesAWallInNoTimeMeetsIt) {
  const Body target = wall(-0.1, 0.1);
  for (const double moment : {1e-310, 1e-200, 1e-12}) {
    const Body ball = ball_on(along_x({0, moment, 1}, {-5, 5, 5}));
    ContinuousSolver solver(3);
    const ClearanceResult found = solver.clearance(ball, target, kEuclidean, nullptr, until(1));
    EXPECT_TRUE(found.touches) << moment;
    EXPECT_EQ(found.lower, 0) << moment;
    EXPECT_NE(solver.time_of_impact(ball, target, until(1)).outcome, Outcome::free) << moment;
  }
}

// The jump within one unit of the last place cannot be split: nothing is proven of it, but the search goes on
// to the moment at which the ball is nearest.
TEST(Continuous, ASpanThatCannotBeSplitIsGivenUpAndNoOther) {
  const double jump = std::nextafter(0.5, 1);
  const Body ball = ball_on(along_x({0, 0.5, jump, 0.8, 1}, {-5, -5, 5, 1, 2}));
  ContinuousSolver solver(3);
  const ClearanceResult found = solver.clearance(ball, wall(-0.1, 0.1), kEuclidean, nullptr, until(1));
  EXPECT_EQ(found.lower, 0);
  EXPECT_NEAR(found.upper, 0.4, 1e-12);
  EXPECT_EQ(found.time, 0.8);
}

TEST(Continuous, SpeedsWhoseSquaresOverflowEndNoRun) {
  const Body target = wall(-0.1, 0.1);
  for (const double speed : {1e155, 1e200, 1e300}) {
    TwistMotion::Rates rates;
    rates.velocity = Eigen::Vector3d(speed, 0, 0);
    const Body through = ball_on(std::make_shared<TwistMotion>(at_x(-5), rates, 0.0));
    rates.velocity[0] = -speed;
    const Body away = ball_on(std::make_shared<TwistMotion>(at_x(-5), rates, 0.0));
    ContinuousSolver solver(3);
    ContinuousOptions options = until(1);
    options.max_steps = 500;
    for (options.to = 10 / speed; options.to < 1e12 / speed; options.to *= 1e9) {
      EXPECT_NE(solver.time_of_impact(through, target, options).outcome, Outcome::free) << speed;
      EXPECT_NE(solver.time_of_impact(away, target, options).outcome, Outcome::contact) << speed;
      EXPECT_LE(solver.clearance(through, target, kEuclidean, nullptr, options).lower, 0) << speed;
      EXPECT_LE(solver.clearance(away, target, kEuclidean, nullptr, options).lower, 4.4) << speed;
    }
  }
}

TEST(Continuous, AClearanceOfBodiesThatMeetSaysWhenTheyFirstDo) {
  Random random(42);
  for (int trial = 0; trial < 30; ++trial) {
    const double first = uniform(random, 0.1, 0.6);
    // At x = -0.6 the ball touches; it stays inside for a while and leaves.
    const Body ball = ball_on(along_x({0, first, 0.9, 1}, {-5, -0.6, 0.2, -5}));
    ContinuousSolver solver(3);
    const ClearanceResult found = solver.clearance(ball, wall(-0.1, 0.1), kEuclidean, nullptr, until(1));
    ASSERT_TRUE(found.touches);
    EXPECT_NEAR(found.time, first, 1e-9);
    EXPECT_LE(found.no_contact_before, first);
    EXPECT_GE(found.no_contact_before, first - 1e-5);
    EXPECT_EQ(found.upper, 0);
  }
}

TEST(Continuous, AQueryThatIsStoppedAnswersWithWhatIsProven) {
  const Body ball = ball_on(along_x({0, 1}, {-5, -1}));
  ContinuousOptions options = until(1);
  options.stop = [] { return true; };
  ContinuousSolver solver(3);
  EXPECT_EQ(solver.time_of_impact(ball, wall(-0.1, 0.1), options).outcome, Outcome::undecided);
  EXPECT_LE(solver.clearance(ball, wall(-0.1, 0.1), kEuclidean, nullptr, options).lower, 0.4);
}

/// A leg: a hip that swings, a thigh, a shank on the thigh's knee, and a disc about the axis of the knee that
/// the shank carries, at a distance from the thigh that does not change.
struct Leg {
  std::vector<Body> links;

  Leg() {
    auto tree = std::make_shared<KinematicTree>();
    auto trajectory = std::make_shared<JointTrajectory>();
    for (int i = 0; i < 21; ++i) trajectory->times.push_back(0.1 * i);
    trajectory->values.resize(3, 21);
    const auto add = [&](const SmallVector& t, JointKind kind, const Eigen::Vector3d& axis, int joint) {
      TreeLink link;
      link.parent = static_cast<int>(tree->links.size()) - 1;
      link.origin = Placement::identity(3);
      link.origin.t = t;
      link.kind = kind;
      link.axis = axis;
      link.joint = joint;
      tree->links.push_back(link);
    };
    add(Eigen::Vector3d(0.3, 0.1, 0), JointKind::revolute, Eigen::Vector3d::UnitX(), 0);
    add(Eigen::Vector3d(0, 0.08, 0), JointKind::revolute, Eigen::Vector3d::UnitY(), 1);
    add(Eigen::Vector3d(0, 0.06, -0.25), JointKind::revolute, Eigen::Vector3d::UnitY(), 2);
    add(Eigen::Vector3d(0, 0, 0), JointKind::fixed, Eigen::Vector3d::UnitX(), -1);
    for (Eigen::Index k = 0; k < 21; ++k) {
      const double phase = 0.8 * static_cast<double>(k);
      trajectory->values.col(k) << 0.1 * std::sin(phase), 0.5 + 0.35 * std::sin(phase),
          0.45 * std::cos(phase) - 1.1;
    }
    const Vector zero = Vector::Zero(3);
    const std::vector<SetPointer> shapes = {
        std::make_shared<Ball>(zero, 0.05),
        std::make_shared<Box>(Eigen::Vector3d(-0.03, -0.02, -0.25), Eigen::Vector3d(0.03, 0.02, 0)),
        std::make_shared<Cylinder>(Eigen::Vector3d(0, 0, -0.25), Eigen::Vector3d(0, 0, -0.05), 0.02),
        std::make_shared<Cylinder>(Eigen::Vector3d(0, -0.034, 0), Eigen::Vector3d(0, 0.03, 0), 0.045)};
    for (int i = 0; i < 4; ++i) {
      links.push_back(make_body("link", {shapes[static_cast<std::size_t>(i)]},
                                LinkMotion::make(tree, trajectory, placement_of_base(), i)));
    }
  }

  static Placement placement_of_base() {
    Random random(43);
    return placement(random, 3, 1.0);
  }
};

TEST(Continuous, LinksThatKeepTheirDistanceTakeFewSolves) {
  const Leg leg;
  ContinuousSolver solver(3);
  const ClearanceResult found = solver.clearance(leg.links[1], leg.links[3], kEuclidean, nullptr, until(2));
  EXPECT_NEAR(found.upper, 0.006, 1e-6);
  EXPECT_GE(found.lower, (1 - 1e-3) * found.upper);
  EXPECT_LT(solver.counters().distance_solves, 300);  // by the speeds of both links 40 000
}

TEST(Continuous, LinksOfARobotKeepTheirAnswersInTheSpaceOfTheScene) {
  const Leg leg;
  ContinuousSolver solver(3);
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      const Body& one = leg.links[static_cast<std::size_t>(a)];
      const Body& other = leg.links[static_cast<std::size_t>(b)];
      const ClearanceResult found = solver.clearance(one, other, kEuclidean, nullptr, until(2));
      for (int k = 0; k <= 200; ++k) {
        EXPECT_LE(found.lower, brute_force(one, other, 0.01 * k).upper);
      }
      EXPECT_GE(found.upper, brute_force(one, other, found.time).lower);
      ContinuousOptions near = until(2);
      near.contact = 1.01 * found.upper + 1e-9;
      const ImpactResult impact = solver.time_of_impact(one, other, near);
      ASSERT_EQ(impact.outcome, Outcome::contact);
      if (impact.at_upper.point_a.size() == 0) continue;
      const SmallVector way = impact.at_upper.point_b - impact.at_upper.point_a;
      EXPECT_NEAR(way.norm(), brute_force(one, other, impact.upper).upper, 2e-3 * near.contact);
      const Placement back = one.motion->at(impact.upper);
      const SmallVector inside = back.turned_back(impact.at_upper.point_a - back.t);
      EXPECT_LE(inside.norm(), one.reach);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_continuous_limits
