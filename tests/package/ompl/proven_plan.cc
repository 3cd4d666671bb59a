// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A ball on two sliding joints goes around another one: OMPL plans, raygauge proves.
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <raygauge/ompl.h>
#include <raygauge/raygauge.h>

#include <cstdio>

namespace ob = ompl::base;

int main() {
  raygauge::RobotModel robot;
  robot.joints = 2;
  for (int i = 0; i < 2; ++i) {
    raygauge::TreeLink link;
    link.parent = i - 1;
    link.origin = raygauge::Placement::identity(3);
    link.kind = raygauge::JointKind::prismatic;
    link.axis = Eigen::Vector3d::Unit(i);
    link.joint = i;
    robot.tree.links.push_back(link);
  }
  const auto ball = std::make_shared<raygauge::Ball>(Eigen::Vector3d::Zero(), 0.5);
  robot.bodies = {{"mover", 1, {ball}}};
  const auto still = std::make_shared<raygauge::StaticMotion>(raygauge::Placement::identity(3));

  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(-3, 3);
  ompl::geometric::SimpleSetup setup(space);
  const std::vector<raygauge::Body> obstacles = {raygauge::make_body("obstacle", {ball}, still)};
  const auto checkers = std::make_shared<raygauge::EdgeCheckers>(robot, obstacles);
  raygauge::set_proven_validity(setup.getSpaceInformation(), checkers);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
  ob::ScopedState<> start(space), goal(space);
  start[0] = -2, start[1] = 0, goal[0] = 2, goal[1] = 0;
  setup.setStartAndGoalStates(start, goal);
  if (setup.solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION) return 1;
  std::puts("a path, proven at every time");
  return 0;
}
