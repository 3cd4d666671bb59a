// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/plane_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/scene/random_scenes.h"

namespace raygauge::test_plane_steps {
namespace {

using namespace random_scenes;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MotionPointer twist(Random& random, int n, bool accelerated) {
  TwistMotion::Rates rates;
  rates.velocity = uniform_vector(random, n, 2);
  if (accelerated) rates.acceleration = uniform_vector(random, n, 10);
  for (int k = n == 2 ? 2 : 0; k < 3; ++k) rates.spin[k] = uniform(random, -5, 5);
  return std::make_shared<TwistMotion>(placement(random, n, 2), rates, 0);
}

SmallVector between(const SmallVector& u, const SmallVector& w, double share) {
  const double angle = std::acos(std::min(1.0, u.dot(w)));
  return (std::sin((1 - share) * angle) * u + std::sin(share * angle) * w) / std::sin(angle);
}

// u and w are known to rounding only, and so is the place that the test looks at.
TEST(PlaneSteps, what_is_between_planes_that_turn_is_never_less_than_the_bound) {
  constexpr double kRounding = 1e-13;
  constexpr int kLooks = 16;
  Random random(39);
  const SceneMetric euclidean;
  int close = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const int n = 2 + trial % 2;
    const Body a = make_body("a", {shape(random, n, trial % kShapes)}, twist(random, n, trial % 3 == 0));
    const Body b = make_body("b", {shape(random, n, trial / kShapes % kShapes)}, twist(random, n, false));
    const double time = std::pow(10, uniform(random, -4, -0.5));
    const SmallVector u = uniform_vector(random, n, 1).normalized();
    const SmallVector w = (u + uniform_vector(random, n, 3 * time)).normalized();
    PairSolver solver(n);
    PartWatch watch(solver, a, b, euclidean, nullptr);
    PlaneSteps steps(watch);
    const double bound = steps.least_turning(u, w, 0, time, PairMotion(watch, 0, time));
    if (std::isinf(bound)) continue;
    double least = kInfinity;
    SmallVector arm_a, arm_b;
    for (int k = 0; k <= kLooks; ++k) {
      const double share = k / static_cast<double>(kLooks);
      least = std::min(least, watch.apart_along(share * time, between(u, w, share), arm_a, arm_b));
    }
    EXPECT_LE(bound, least + kRounding) << trial;
    if (bound > least - 100 * time * time) ++close;  // of second order in time
  }
  EXPECT_GT(close, 500);
}

TEST(PlaneSteps, planes_that_turn_too_far_prove_nothing) {
  Random random(1);
  const SceneMetric euclidean;
  const Body a = make_body("a", {shape(random, 3, 1)}, twist(random, 3, false));
  PairSolver solver(3);
  PartWatch watch(solver, a, a, euclidean, nullptr);
  PlaneSteps steps(watch);
  const SmallVector u = Eigen::Vector3d::UnitX(), w = Eigen::Vector3d::UnitY();
  EXPECT_EQ(steps.least_turning(u, w, 0, 1, PairMotion(watch, 0, 1)), -kInfinity);
}

}  // namespace
}  // namespace raygauge::test_plane_steps
