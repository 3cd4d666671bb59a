// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planner/plan_path.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/scene/ompl/planar_arm.h"

namespace raygauge::test_plan_path {
namespace {

PlanRequest request() {
  PlanRequest plan;
  plan.robot = planar_arm::robot();
  plan.obstacles = planar_arm::ball();
  plan.lower = {-2, -2.6};
  plan.upper = {2, 2.6};
  plan.start = {-0.8, 0};
  plan.goal = {0.8, 0};
  return plan;
}

TEST(PlanPath, EveryPlannerFindsAPathThatIsProvenWithItsMargin) {
  for (const std::string& name : planner_names()) {
    PlanRequest plan = request();
    plan.planner = name;
    plan.options.margin = 0.02;
    const PlannedPath path = plan_path(plan);
    ASSERT_TRUE(path.found()) << name;
    const Eigen::Index last = path.values.cols() - 1;
    EXPECT_EQ(path.values(0, 0), -0.8);
    EXPECT_EQ(path.values(0, last), 0.8);
    EXPECT_GT(path.length, 1.6);  // the straight line is in contact
    EXPECT_GT(path.motions, 0);
    JointTrajectory trajectory;
    trajectory.values = path.values;
    for (Eigen::Index k = 0; k <= last; ++k) trajectory.times.push_back(static_cast<double>(k));
    EXPECT_EQ(EdgeChecker(plan.robot, plan.obstacles, plan.options).path(trajectory).outcome,
              EdgeOutcome::free);
    for (Eigen::Index k = 0; k <= last; ++k) {
      EXPECT_LE(path.values.col(k).cwiseAbs().maxCoeff(), 2.6);
    }
  }
}

TEST(PlanPath, TheSameSeedGivesTheSamePath) {
  PlanRequest plan = request();
  const PlannedPath one = plan_path(plan), again = plan_path(plan);
  EXPECT_EQ(one.values, again.values);
  plan.seed = 2;
  EXPECT_FALSE(plan_path(plan).values == one.values);
}

TEST(PlanPath, NoPathIsFoundWhereThereIsNone) {
  PlanRequest plan = request();
  plan.lower[1] = plan.start[1] - 0.01;  // the outer rod cannot fold
  plan.upper[1] = plan.start[1] + 0.01;
  plan.time_limit = 0.2;
  EXPECT_FALSE(plan_path(plan).found());
}

TEST(PlanPath, AStartOrGoalInContactIsNamed) {
  PlanRequest plan = request();
  plan.goal = {0, 0};
  try {
    plan_path(plan);
    FAIL() << "planned to a goal in contact";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(), "the goal of the plan is in contact: 'outer' and 'ball'");
  }
  plan = request();
  plan.start = {-2.5, 0};
  EXPECT_THROW(plan_path(plan), InvalidParameterError);
  plan = request();
  plan.planner = "rrt_conect";
  EXPECT_THROW(plan_path(plan), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_plan_path
