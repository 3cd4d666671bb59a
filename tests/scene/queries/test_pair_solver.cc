// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/pair_solver.h"

#include <gtest/gtest.h>

#include <limits>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"

namespace raygauge::test_pair_solver {
namespace {

using Eigen::Vector2d;

// A segment and a point beside it, which were "in contact" after two boxes had been solved.
TEST(PairSolver, KeepsNothingOfOtherPairs) {
  const auto rest = std::make_shared<StaticMotion>(Placement::identity(2));
  const auto body = [&](const char* name, std::shared_ptr<const ConvexSet> set) {
    return make_body(name, {std::move(set)}, rest);
  };
  const Body one = body("one", std::make_shared<Box>(Vector2d(-1, -1), Vector2d(1, 1)));
  const Body other = body("other", std::make_shared<Box>(Vector2d(2, 2), Vector2d(3, 3)));
  const Body segment =
      body("s", std::make_shared<Capsule>(Vector2d(0.036937123349985113, -0.24224713534436512),
                                          Vector2d(-0.35598201633707455, -0.20242372137475048), 0));
  const Body point =
      body("p", std::make_shared<Ball>(Vector2d(-0.10844295833423767, -0.22751247217571341), 0));
  const SceneMetric metric;
  PairSolver solver(2);
  const Placement far = make_placement(Eigen::Matrix2d::Identity(), Vector2d(100, 0));
  PairMemory memory, memory_of_point;
  solver.bind(one, other, metric);
  solver.place(far, far);
  solver.distance(memory, std::numeric_limits<double>::infinity(), false, false);
  solver.bind(segment, point, metric);
  solver.place(Placement::identity(2), Placement::identity(2));
  const PairAnswer& answer =
      solver.distance(memory_of_point, std::numeric_limits<double>::infinity(), false, false);
  EXPECT_NEAR(answer.value, 1.06245e-13, 1e-18);
}

}  // namespace
}  // namespace raygauge::test_pair_solver
