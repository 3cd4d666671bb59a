// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/half_space.h"
#include "tests/scene/simulation/reacting_scenes.h"

namespace raygauge::test_overlap_at_start {
namespace {

using namespace reacting_scenes;

Reacting resolving(double to) {
  Reacting scene(to);
  scene.dynamics.contact = ContactLaw();
  scene.dynamics.overlap_at_start = StartOverlap::resolved;
  return scene;
}

double height(const Simulation& found, std::size_t body, double t) {
  return found.scene.bodies[body].motion->at(t).t[2];
}

double least_distance(const Simulation& found) {
  double least = 1e300;
  for (const StepRecord& step : found.steps) least = std::min(least, step.least_distance);
  return least;
}

TEST(OverlapAtStart, IsResolvedByTheShortestWayAndLessOfHeavierBodies) {
  Reacting scene = resolving(0.01);
  scene.add(ball(1), v(0, 0, 0), 3);
  scene.add(ball(1), v(0, 0, 1.6), 1);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_NEAR(height(found, 0, 0), -0.1, 1e-5);
  EXPECT_NEAR(height(found, 1, 0), 1.9, 1e-5);
  EXPECT_NEAR(found.moved_at_start, 0.3, 1e-5);
  EXPECT_GE(least_distance(found), -found.tolerance);
  EXPECT_NEAR(height(found, 1, 0.01), height(found, 1, 0), 1e-9);  // nothing pushes them on
}

TEST(OverlapAtStart, OfAStackIsResolvedAndItStands) {
  Reacting scene = resolving(0.1);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact->friction = 0.5;
  scene.add(std::make_shared<HalfSpace>(v(0, 0, 1), 0), v(0, 0, 0), 0);
  for (int k = 0; k < 5; ++k) scene.add(box(0.5, 0.5, 0.5), v(0.01 * k, 0, 0.4 + 0.93 * k), 1);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_GE(least_distance(found), -found.tolerance);
  for (std::size_t k = 1; k <= 5; ++k)
    EXPECT_NEAR(height(found, k, 0.1), static_cast<double>(k) - 0.5, 1e-4) << k;
  EXPECT_NEAR(found.moved_at_start, 5 - 0.5 - (0.4 + 0.93 * 4), 1e-3);
}

TEST(OverlapAtStart, LeavesBodiesThatAreApartWhereTheyAre) {
  Reacting scene = resolving(0.01);
  scene.add(ball(1), v(0, 0, 0), 1);
  scene.add(ball(1), v(0, 0, 2.1), 1);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_EQ(found.moved_at_start, 0);
  EXPECT_EQ(height(found, 1, 0), 2.1);
}

TEST(OverlapAtStart, OfABodyBetweenWallsTooCloseIsRefusedWithItsDepth) {
  Reacting scene = resolving(0.01);
  scene.add(box(5, 5, 1), v(0, 0, -1.9), 0);
  scene.add(box(5, 5, 1), v(0, 0, 1.9), 0);
  scene.add(ball(1), v(0, 0, 0.02), 1);
  try {
    simulate(scene.scene, scene.dynamics, nullptr);
    FAIL() << "the ball has no room";
  } catch (const InvalidParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be moved apart"), std::string::npos) << error.what();
  }
  scene.dynamics.overlap_at_start = StartOverlap::refused;
  EXPECT_THROW(simulate(scene.scene, scene.dynamics, nullptr), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_overlap_at_start
