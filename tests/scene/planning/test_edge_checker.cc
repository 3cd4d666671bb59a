// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/edge_checker.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "raygauge/exceptions.h"
#include "raygauge/scene/continuous.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_edge_checker {
namespace {

using namespace random_robots;

constexpr double kRodRadius = 0.05, kBallRadius = 0.1;
constexpr double kContact = 1e-6;  // EdgeOptions::contact

/// Whose rods do not meet those that they hang on.
RobotModel planar_arm(int rods) {
  RobotModel robot = random_robots::planar_arm(rods, kRodRadius);
  robot.ignored = joined_bodies(robot);
  return robot;
}

Body ball_at(double x, double y, double z, double radius = kBallRadius) {
  Placement where = Placement::identity(3);
  where.t = vector3(x, y, z);
  return make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), radius)},
                   std::make_shared<StaticMotion>(where));
}

using Values = std::vector<double>;

// A rod that turns towards a ball at the distance R meets it where R sin(angle between) is the sum of the
// radii.
TEST(EdgeChecker, ARodMeetsABallAtTheAngleOfTheClosedForm) {
  const double R = 0.9, at = EIGEN_PI / 3;
  for (const double margin : {0.0, 0.01, 0.2}) {
    EdgeOptions options;
    options.margin = margin;
    EdgeChecker checker(planar_arm(1), {ball_at(R * std::cos(at), R * std::sin(at), 0)}, options);
    const double reached = at - std::asin((kRodRadius + kBallRadius + margin) / R);
    EXPECT_EQ(checker.edge(Values{-1}, Values{reached - 3 * kContact}).outcome, EdgeOutcome::free);
    EXPECT_EQ(checker.edge(Values{-2}, Values{reached - 1e-4}).outcome, EdgeOutcome::free);
    const EdgeResult& past = checker.edge(Values{-1}, Values{reached + 1e-5});
    ASSERT_EQ(past.outcome, EdgeOutcome::contact);
    EXPECT_GE(-1 + past.time * (reached + 1e-5 + 1), reached - 2 * kContact);
    EXPECT_LE(past.upper, margin + kContact);
    EXPECT_EQ(past.body_a, 0);
    EXPECT_EQ(past.body_b, 1);
    EXPECT_EQ(checker.name(past.body_b), "ball");
    EXPECT_EQ(checker.edge(Values{0}, Values{EIGEN_PI}).outcome, EdgeOutcome::contact);  // through it
  }
}

// A tip that passes a ball on a tangent.
TEST(EdgeChecker, AnEdgeThatGrazesIsFreeOnlyWhereItDoesNotTouch) {
  RobotModel robot = planar_arm(1);
  robot.tree.links[0].kind = JointKind::prismatic;
  robot.tree.links[0].axis = Eigen::Vector3d::UnitX();
  robot.bodies[0].parts = {std::make_shared<Ball>(Vector::Zero(3), 0.5)};
  for (const double gap : {1e-2, 1e-4, 3e-6}) {
    EdgeChecker checker(robot, {ball_at(0.123, 0.5 + kBallRadius + gap, 0)});
    EXPECT_EQ(checker.edge(Values{-3}, Values{2}).outcome, EdgeOutcome::free) << gap;
    EXPECT_LT(checker.edge(Values{-3}, Values{2}).looks, 60);
  }
  for (const double gap : {0.0, -1e-9, -1e-4}) {
    EdgeChecker checker(robot, {ball_at(0.123, 0.5 + kBallRadius + gap, 0)});
    const EdgeResult& result = checker.edge(Values{-3}, Values{2});
    EXPECT_EQ(result.outcome, EdgeOutcome::contact) << gap;
    EXPECT_NEAR(-3 + 5 * result.time, 0.123, 2e-2);
  }
}

// The whole length of a face slides along a wall: between the margins of proof nothing but looks would
// decide.
TEST(EdgeChecker, AnEdgeAlongAWallIsProven) {
  RobotModel robot = planar_arm(1);
  robot.tree.links[0].kind = JointKind::prismatic;
  robot.tree.links[0].axis = Eigen::Vector3d::UnitX();
  robot.bodies[0].parts = {std::make_shared<Box>(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1))};
  const auto wall = std::make_shared<Box>(Eigen::Vector3d(-9, -2, -9), Eigen::Vector3d(9, -1 - 2e-6, 9));
  EdgeChecker checker(robot,
                      {make_body("wall", {wall}, std::make_shared<StaticMotion>(Placement::identity(3)))});
  EXPECT_EQ(checker.edge(Values{-3}, Values{2}).outcome, EdgeOutcome::free);
  EXPECT_EQ(checker.edge(Values{-3}, Values{2}).looks, 0);  // by the plane of the edge before
}

TEST(EdgeChecker, AnEdgeOfNoLengthIsAConfiguration) {
  EdgeChecker checker(planar_arm(2), {ball_at(1, 1, 0)});
  for (const Values& q : {Values{0, 0}, Values{0, EIGEN_PI / 2}, Values{1, 1}, Values{0.8, 0}}) {
    const EdgeOutcome outcome = checker.configuration(q).outcome;
    EXPECT_EQ(checker.edge(q, q).outcome, outcome);
  }
  EXPECT_EQ(checker.configuration(Values{0, 0}).outcome, EdgeOutcome::free);
  EXPECT_EQ(checker.configuration(Values{0, EIGEN_PI / 2}).outcome, EdgeOutcome::contact);
  EXPECT_EQ(checker.edge(Values{0, EIGEN_PI / 2}, Values{0, 0}).outcome,
            EdgeOutcome::contact);  // from the start
  EXPECT_EQ(checker.edge(Values{0, 0}, Values{0, EIGEN_PI / 2}).outcome, EdgeOutcome::contact);  // at the end
}

TEST(EdgeChecker, ARobotMeetsItselfButForIgnoredPairs) {
  RobotModel robot = planar_arm(3);
  const Values open = {0, 0, 0}, closed = {0, 2.2, 2.2};  // a triangle, closed for 2π/3
  EdgeChecker checker(robot, {});
  const EdgeResult& result = checker.edge(open, closed);
  ASSERT_EQ(result.outcome, EdgeOutcome::contact);
  EXPECT_EQ(result.body_a, 0);
  EXPECT_EQ(result.body_b, 2);
  EXPECT_EQ(checker.edge(open, Values{3, 1.9, 1.9}).outcome, EdgeOutcome::free);
  robot.ignored.emplace_back(2, 0);
  EXPECT_EQ(EdgeChecker(robot, {}).edge(open, closed).outcome, EdgeOutcome::free);
}

TEST(EdgeChecker, AGraspedObjectCounts) {
  RobotModel robot = planar_arm(1);
  const Body ball = ball_at(0, 1.6, 0);
  EXPECT_EQ(EdgeChecker(robot, {ball}).edge(Values{0}, Values{3}).outcome, EdgeOutcome::free);
  RobotBody held;
  held.name = "held";
  held.origin.t = vector3(1.3, 0, 0);
  held.parts = {std::make_shared<Box>(Eigen::Vector3d(-0.25, -0.1, -0.1), Eigen::Vector3d(0.25, 0.1, 0.1))};
  robot.bodies.push_back(held);
  robot.ignored.emplace_back(0, 1);
  EdgeOptions options;
  options.witness = true;
  EdgeChecker checker(robot, {ball}, options);
  const EdgeResult& result = checker.edge(Values{0}, Values{3});
  ASSERT_EQ(result.outcome, EdgeOutcome::contact);
  EXPECT_EQ(checker.name(result.body_a), "held");
  ASSERT_EQ(result.point_a.size(), 3);
  EXPECT_NEAR(result.point_b.dot(vector3(0, 1, 0)), 1.55, 0.06);
  EXPECT_GE(result.depth, 0);
  EXPECT_LE(result.depth, 0.1);
  robot.ignored.emplace_back(1, 2);
  EXPECT_EQ(EdgeChecker(robot, {ball}).edge(Values{0}, Values{3}).outcome, EdgeOutcome::free);
}

// A ball that crosses the path of the rod's tip: it depends on when.
TEST(EdgeChecker, ObstaclesMoveWhileTheRobotDoes) {
  TwistMotion::Rates rates;
  rates.velocity = vector3(0, -4, 0);
  Placement first = Placement::identity(3);
  first.t = vector3(0.9, 2, 0);
  const Body falling = make_body("falling", {std::make_shared<Ball>(Vector::Zero(3), kBallRadius)},
                                 std::make_shared<TwistMotion>(first, rates, 0.0));
  EdgeChecker checker(planar_arm(1), {falling});
  EXPECT_EQ(checker.edge(Values{0}, Values{0}).outcome, EdgeOutcome::contact);  // at t = 1/2
  EXPECT_EQ(checker.edge(Values{0}, Values{0}, 0, 0.4).outcome, EdgeOutcome::free);
  EXPECT_EQ(checker.edge(Values{0}, Values{3}).outcome, EdgeOutcome::free);  // out of its way by then
  EXPECT_EQ(checker.configuration(Values{0}, 0.5).outcome, EdgeOutcome::contact);
  EXPECT_EQ(checker.configuration(Values{0}, 0.6).outcome, EdgeOutcome::free);
}

// An obstacle that comes and goes within a hundredth of the time.
TEST(EdgeChecker, BreaksOfAnObstaclesMotionAreSeen) {
  const Placement far = Placement{SmallMatrix::Identity(3, 3), vector3(0.5, 5, 0)};
  const Placement near = Placement{SmallMatrix::Identity(3, 3), vector3(0.5, 0, 0)};
  const auto ball = std::make_shared<Ball>(Vector::Zero(3), kBallRadius);
  const std::vector<double> times = {0, 0.3, 0.305, 0.31, 1};
  const Body visit =
      make_body("visit", {ball},
                std::make_shared<KeyframeMotion>(times, std::vector<Placement>{far, far, near, far, far}));
  EdgeChecker checker(planar_arm(1), {visit});
  const EdgeResult& result = checker.edge(Values{0}, Values{0});
  ASSERT_EQ(result.outcome, EdgeOutcome::contact);
  EXPECT_NEAR(result.time, 0.305, 1e-3);
  EXPECT_EQ(checker.edge(Values{0}, Values{0}, 0.31, 1).outcome, EdgeOutcome::free);
  EXPECT_THROW(checker.edge(Values{0}, Values{0}, 0, 1.5), InvalidParameterError);
}

TEST(EdgeChecker, APathEndsAtItsFirstEdgeThatIsNotFree) {
  EdgeChecker checker(planar_arm(1), {ball_at(0, 1, 0)});
  JointTrajectory path;
  path.times = {0, 1, 3, 4};
  path.values.resize(1, 4);
  path.values << 0, 1, -1, -3;
  EXPECT_EQ(checker.path(path).outcome, EdgeOutcome::free);
  path.values << 0, 1, 2, 0;
  const EdgeResult& result = checker.path(path);
  ASSERT_EQ(result.outcome, EdgeOutcome::contact);
  EXPECT_GT(result.time, 1);
  EXPECT_LT(result.time, 3);
}

TEST(EdgeChecker, APathOfOneTimeIsAConfiguration) {
  EdgeChecker checker(planar_arm(1), {ball_at(0, 1, 0)});
  JointTrajectory path;
  path.times = {5};
  path.values.resize(1, 1);
  path.values << 0;
  EXPECT_EQ(checker.path(path).outcome, EdgeOutcome::free);
  path.values << EIGEN_PI / 2;
  const EdgeResult& result = checker.path(path);
  ASSERT_EQ(result.outcome, EdgeOutcome::contact);
  EXPECT_EQ(result.time, 5);
}

TEST(EdgeChecker, AMistakeOfTheCallerIsRefused) {
  RobotModel robot = planar_arm(2);
  EdgeChecker checker(robot, {});
  EXPECT_THROW(checker.edge(Values{0}, Values{0, 0}), DimensionMismatchError);
  EXPECT_THROW(checker.edge(Values{0, 0}, Values{0, std::nan("")}), NonFiniteError);
  EXPECT_THROW(checker.edge(Values{0, 0}, Values{0, 1}, 1, 1), InvalidParameterError);
  EXPECT_THROW(checker.configuration(Values{}), DimensionMismatchError);
  EXPECT_THROW(checker.path({}), InvalidParameterError);
  EXPECT_THROW(checker.name(2), InvalidParameterError);
  for (const EdgeOptions& wrong :
       {EdgeOptions{.margin = -1}, EdgeOptions{.contact = 0}, EdgeOptions{.max_looks = 0}}) {
    EXPECT_THROW(EdgeChecker(robot, {}, wrong), InvalidParameterError);
  }
  robot.ignored.emplace_back(0, 9);
  EXPECT_THROW(EdgeChecker(robot, {}), InvalidParameterError);
  robot.ignored.clear();
  robot.bodies[1].link = 2;
  EXPECT_THROW(EdgeChecker(robot, {}), InvalidParameterError);
  robot.bodies[1].link = 1;
  robot.joints = 1;
  EXPECT_THROW(EdgeChecker(robot, {}), InvalidParameterError);
}

TEST(EdgeChecker, ALimitEndsItUndecided) {
  EdgeOptions options;
  options.max_looks = 1;
  EdgeChecker checker(planar_arm(1), {ball_at(0, 1.2, 0)}, options);
  EXPECT_EQ(checker.edge(Values{0}, Values{4}).outcome, EdgeOutcome::undecided);
  // Numbers that cannot be computed with prove nothing.
  EXPECT_EQ(EdgeChecker(planar_arm(2), {ball_at(0, 1.2, 0)}).edge(Values{0, 0}, Values{1e300, 1e300}).outcome,
            EdgeOutcome::undecided);
}

// Parts in a tree, and the same parts as bodies of their own.
TEST(EdgeChecker, ManyPartsHaveTheVerdictsOfManyBodies) {
  Random random(3);
  const RobotModel robot = planar_arm(3);
  std::int64_t free = 0, tests = 0, tests_of_bodies = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<SetPointer> parts;
    std::vector<Body> bodies;
    const auto stands = std::make_shared<StaticMotion>(placement(random, 3, 0.3));
    for (int k = 0; k < 400; ++k) {
      const double angle = uniform(random, 0.5, 5.5), away = uniform(random, 1, 12);
      const Vector c = vector3(away * std::cos(angle), away * std::sin(angle), uniform(random, -6, 6));
      parts.push_back(std::make_shared<Ball>(c, 0.1));
      bodies.push_back(make_body("part", {parts.back()}, stands));
    }
    EdgeChecker one(robot, {make_body("all", parts, stands)}), many(robot, bodies);
    for (int edge = 0; edge < 5; ++edge) {
      const Values q = configuration(random, robot, 1);
      Values next = configuration(random, robot, 0.2);
      for (std::size_t i = 0; i < q.size(); ++i) next[i] += q[i];
      const EdgeResult result = one.edge(q, next), of_bodies = many.edge(q, next);
      EXPECT_EQ(result.outcome, of_bodies.outcome);
      free += result.outcome == EdgeOutcome::free ? 1 : 0;
      tests += result.ball_tests;
      tests_of_bodies += of_bodies.ball_tests;
    }
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(3 * tests, tests_of_bodies);
}

/// The verdict beside distances of all pairs, solved one by one at many times.
void compare(const RobotModel& robot, const std::vector<Body>& obstacles, const JointTrajectory& trajectory,
             const EdgeOptions& options, const EdgeResult& result) {
  const std::vector<Body> bodies = moving_bodies(robot, obstacles, trajectory);
  constexpr double kRounding = 1e-9;
  if (result.outcome == EdgeOutcome::contact) {
    const BruteForce truth = brute_force(bodies[static_cast<std::size_t>(result.body_a)],
                                         bodies[static_cast<std::size_t>(result.body_b)], result.time);
    RC_ASSERT(truth.lower <= options.margin + options.contact + kRounding);
    RC_ASSERT(!is_ignored(robot, result.body_a, result.body_b));
    return;
  }
  constexpr int kTimes = 40;
  for (int a = 0; a < static_cast<int>(robot.bodies.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
      if (is_ignored(robot, a, b)) continue;
      for (int k = 0; k <= kTimes; ++k) {
        const BruteForce truth =
            brute_force(bodies[static_cast<std::size_t>(a)], bodies[static_cast<std::size_t>(b)],
                        static_cast<double>(k) / kTimes);
        RC_ASSERT(!truth.intersecting);
        RC_ASSERT(truth.upper >= options.margin - kRounding);
      }
    }
  }
}

RC_GTEST_PROP(EdgeChecker, NoVerdictIsFalse, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const RobotModel model = robot(random);
  const std::vector<Body> around =
      obstacles(random, 1 + static_cast<int>(random() % 3), uniform(random, 1, 8));
  EdgeOptions options;
  if (random() % 2 == 0) options.margin = uniform(random, 0, 0.2);
  EdgeChecker checker(model, around, options);
  Values q = configuration(random, model, 2);
  for (int k = 0; k < 4; ++k) {
    Values next = configuration(random, model, 2);
    for (std::size_t i = 0; i < q.size(); ++i) next[i] = q[i] + uniform(random, 0, 0.5) * next[i];
    const EdgeResult warm = checker.edge(q, next);
    RC_ASSERT(warm.outcome != EdgeOutcome::undecided);
    RC_TAG(warm.outcome == EdgeOutcome::free ? "free" : "contact");
    compare(model, around, line(q, next), options, warm);
    EdgeChecker fresh(model, around, options);  // what is kept changes no verdict
    const EdgeResult cold = fresh.edge(q, next);
    RC_ASSERT(cold.outcome == warm.outcome);
    if (warm.outcome == EdgeOutcome::free) {
      RC_ASSERT(checker.configuration(q, 0).outcome == EdgeOutcome::free);
      RC_ASSERT(checker.configuration(next, 1).outcome == EdgeOutcome::free);
    }
    checker.forget();
    const EdgeResult again = checker.edge(q, next);
    RC_ASSERT(again.looks == cold.looks && again.plane_tests == cold.plane_tests);
    RC_ASSERT(again.lower == cold.lower && again.upper == cold.upper && again.body_b == cold.body_b);
    q = next;
  }
}

// The first contact by time_of_impact() is not after the contact that an edge has, and free edges have none.
RC_GTEST_PROP(EdgeChecker, ItAgreesWithTheTimeOfImpact, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const RobotModel model = robot(random);
  const std::vector<Body> around = obstacles(random, 2, 3);
  const Values q0 = configuration(random, model, 2), q1 = configuration(random, model, 2);
  const EdgeResult result = EdgeChecker(model, around).edge(q0, q1);
  const std::vector<Body> bodies = moving_bodies(model, around, line(q0, q1));
  ContinuousSolver solver(3);
  ContinuousOptions over;
  over.to = 1;
  for (int a = 0; a < static_cast<int>(model.bodies.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
      const bool is_found =
          result.outcome == EdgeOutcome::contact && a == result.body_a && b == result.body_b;
      if (is_ignored(model, a, b) || (result.outcome == EdgeOutcome::contact && !is_found)) continue;
      const ImpactResult impact = solver.time_of_impact(bodies[static_cast<std::size_t>(a)],
                                                        bodies[static_cast<std::size_t>(b)], over);
      if (is_found) RC_ASSERT(impact.lower <= result.time);
      // A distance below `contact` is a contact there.
      if (impact.outcome == ImpactResult::Outcome::contact && !is_found)
        RC_ASSERT(!impact.at_upper.intersecting());
    }
  }
}

}  // namespace
}  // namespace raygauge::test_edge_checker
