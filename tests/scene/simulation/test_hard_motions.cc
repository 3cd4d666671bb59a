// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/half_space.h"
#include "scene/simulation/piecewise_motion.h"
#include "scene/simulation/simulation_part.h"
#include "tests/scene/simulation/reacting_scenes.h"

/// Hard cases with known truth, at steps that differ by powers of ten.
namespace raygauge::test_hard_motions {
namespace {

using namespace reacting_scenes;

constexpr double kSteps[] = {1e-2, 1e-3, 1e-4};

void expect_proven(const Simulation& found) {
  for (const StepRecord& step : found.steps) {
    EXPECT_GE(step.least_distance, -found.tolerance) << step.time;
    EXPECT_LE(step.residual, 1e-8) << step.time;
  }
}

std::int64_t substeps_of(const Simulation& found) {
  std::int64_t all = 0;
  for (const StepRecord& step : found.steps) all += step.substeps;
  return all;
}

const PiecewiseMotion& motion_of(const Simulation& found, std::size_t body) {
  return dynamic_cast<const PiecewiseMotion&>(*found.scene.bodies[body].motion);
}

// The first ball meets four that touch each other: its velocity goes on to the last one.
TEST(HardMotions, a_row_of_balls_hands_on_velocity_and_energy_at_every_step) {
  for (const double step : kSteps) {
    Reacting scene(0.2);
    scene.dynamics.step = step;
    scene.dynamics.contact = ContactLaw{std::nullopt, 1.0};
    for (int k = 0; k < 5; ++k) scene.add(ball(0.1), v(k == 0 ? -0.1 : 0.2 * k, 0, 0), 1);
    scene.dynamics.bodies[0].velocity = v(3, 0, 0);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    expect_proven(found);
    // The first one has a way of 0.1 to go.
    EXPECT_NEAR(motion_of(found, 4).at(0.2).t[0], 0.8 + 3 * 0.2 - 0.1, 1e-6);
    for (const StepRecord& row : found.steps) EXPECT_NEAR(row.kinetic, 4.5, 1e-9);
  }
}

// A body 10^4 times as heavy rests on a light one.
TEST(HardMotions, a_heavy_cube_rests_on_a_light_one_at_every_step) {
  for (const double step : {1e-2, 1e-3}) {
    Reacting scene(0.5);
    scene.dynamics.step = step;
    scene.dynamics.gravity = v(0, 0, -9.81);
    scene.dynamics.contact = ContactLaw{};
    scene.add(box(0.1, 0.1, 0.1), v(0, 0, 0.1), 1);
    scene.add(box(0.1, 0.1, 0.1), v(0, 0, 0.3), 1e4);
    scene.add(floor(), v(0, 0, 0), 0);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    expect_proven(found);
    for (const std::size_t k : {0U, 1U})
      EXPECT_LE((motion_of(found, k).at(0.5).t - scene.scene.bodies[k].motion->at(0).t).norm(), 1e-9);
  }
}

// Two edges cross, and one of them tips: the plane between them turns with neither body.
TEST(HardMotions, a_rod_that_tips_across_an_edge_needs_few_cuts) {
  Reacting scene(0.05);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{};
  const double side = 0.1, top = std::sqrt(2.0) * side;
  const auto quarter = [](const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(std::acos(-1.0) / 4, axis).toRotationMatrix();
  };
  scene.add(box(1, side, side), v(0, 0, -top), 0, quarter(v(1, 0, 0)));
  scene.add(box(side, 0.5, side), v(0, 0.1, top), 1, quarter(v(0, 1, 0)));
  scene.dynamics.bodies[1].spin = v(2, 0.5, 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  expect_proven(found);
  EXPECT_LE(substeps_of(found), 3 * static_cast<std::int64_t>(found.steps.size()));
}

// They fall on each other, roll and slide. Nothing rebounds, so no blow cuts a step; and where bodies roll,
// the middle of a step is proven by the planes that are between them then.
TEST(HardMotions, a_heap_without_rebounds_needs_few_cuts) {
  Reacting scene(0.35);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{0.5, std::nullopt};
  scene.dynamics.tolerance = 1e-4;
  scene.add(floor(), v(0, 0, 0), 0);
  const Shape capsule = std::make_shared<Capsule>(v(0, 0, -0.05), v(0, 0, 0.05), 0.05);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int k = 0; k < 27; ++k) {
    const Eigen::Matrix3d R = Eigen::Quaterniond(some(random), some(random), some(random), some(random))
                                  .normalized()
                                  .toRotationMatrix();
    const Eigen::Vector3d at(0.2 * (k % 3) + 0.01 * some(random), 0.2 * (k / 3 % 3) + 0.01 * some(random),
                             0.12 + 0.25 * (k / 9));
    scene.add(k % 4 == 0 ? box(0.07, 0.06, 0.05) : k % 4 == 1 ? ball(0.08) : capsule, at, 1, R);
  }
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  expect_proven(found);
  EXPECT_LE(substeps_of(found), 1.2 * static_cast<double>(found.steps.size()));
}

// A plate turns about its middle above a ball: where they are nearest nothing closes, and yet its turn of a
// tenth of a radian brings it there by half of H φ².
TEST(HardMotions, a_plate_that_turns_into_a_ball_within_a_step_joins_its_problem_and_cuts_nothing) {
  constexpr double kStep = 1e-2, kSpin = 10, kHeight = 0.5;  // of the plate's middle above the ball's
  constexpr double kGap = kHeight * kSpin * kSpin * kStep * kStep / 4;
  Reacting all(kStep);
  all.add(box(0.5, 0.4, 0.1), v(0, 0, kHeight), 1);
  all.dynamics.bodies.back().spin = v(0, kSpin, 0);
  all.add(ball(kHeight - 0.1 - kGap), v(0, 0, 0), 1);
  all.dynamics.contact = ContactLaw{};
  all.dynamics.step = kStep;
  all.dynamics.tolerance = 1e-4;
  const Simulation found = simulate(all.scene, all.dynamics, nullptr);
  ASSERT_EQ(found.steps.size(), 1U);
  EXPECT_EQ(found.steps[0].substeps, 1);
  EXPECT_GT(found.steps[0].contacts, 0);
  EXPECT_GE(found.steps[0].least_distance, -found.tolerance);
}

// Of a half-space nothing is proven but across its own normal.
TEST(HardMotions, a_fast_body_that_does_not_rebound_arrives_on_a_half_space_at_the_end_of_a_step) {
  Reacting scene(0.1);
  scene.dynamics.step = 1e-2;
  scene.dynamics.contact = ContactLaw{};
  scene.add(std::make_shared<HalfSpace>(v(0.3, 0.2, 1), 0.0), v(0, 0, 0), 0);
  scene.add(ball(0.1), v(0, 0, 3), 1);
  scene.dynamics.bodies[1].velocity = v(1, 0, -60);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  expect_proven(found);
  EXPECT_LE(substeps_of(found), static_cast<std::int64_t>(found.steps.size()));
}

// A plate comes down on a ball, leaning by 6 degrees: without friction the ball is squeezed out, and nothing
// else can be. Without a lean no impulse gets it out.
Reacting pressed(double lean, std::optional<double> friction) {
  Reacting scene(0.3);
  scene.dynamics.contact = ContactLaw{friction, std::nullopt};
  scene.add(ball(0.1), v(0, 0, 0.1), 1);
  scene.add(floor(), v(0, 0, 0), 0);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(lean, v(0, 1, 0)).toRotationMatrix();
  TwistMotion::Rates rates;
  rates.velocity = v(0, 0, -0.5);
  const auto down = std::make_shared<TwistMotion>(make_placement(R, v(0, 0, 0.32)), rates, 0.0);
  scene.scene.bodies.push_back(make_body("press", {box(1, 1, 0.1)}, down));
  scene.dynamics.bodies.emplace_back();
  return scene;
}

std::string refusal(const Reacting& scene) {
  try {
    expect_proven(simulate(scene.scene, scene.dynamics, nullptr));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(HardMotions, a_ball_under_a_press_is_squeezed_out_or_the_simulation_ends_in_a_line) {
  const std::string jammed = " s 'body0' is jammed by 'body1', 'press': no impulses keep them apart";
  const double lean = 0.1;
  EXPECT_EQ(refusal(pressed(lean, std::nullopt)), "");
  EXPECT_EQ(refusal(pressed(lean, 0.02)), "");
  // The plate is 0.02 above it at first, and 0.2 (1 / cos(lean) - 1) less.
  EXPECT_EQ(refusal(pressed(lean, 0.5)), "simulation: at 0.037992" + jammed);
  EXPECT_EQ(refusal(pressed(0, 0.5)), "simulation: at 0.040000" + jammed);
  EXPECT_EQ(refusal(pressed(0, std::nullopt)), "simulation: at 0.040000" + jammed);
}

// The press arrives at 0.04 s, in the middle of a step.
TEST(HardMotions, what_was_done_until_a_jam_is_kept) {
  Reacting scene = pressed(0, 0.5);
  scene.dynamics.step = 3e-3;
  scene.scene.instants = {0, 0.01, 0.02, 0.3};
  for (const int threads : {1, 2}) {
    SimulationHooks hooks;
    hooks.threads = threads;
    std::size_t stored = 0;
    hooks.due = [] { return false; };
    hooks.store = [&stored](const SimulationPart& part) { stored += part.steps.size(); };
    try {
      simulate(scene.scene, scene.dynamics, nullptr, hooks);
      ADD_FAILURE() << "no jam";
    } catch (const SimulationError& error) {
      const Simulation& done = error.done();
      expect_proven(done);
      ASSERT_EQ(done.steps.size(), 13U);
      EXPECT_EQ(stored, done.steps.size());
      EXPECT_DOUBLE_EQ(done.steps.back().time, 0.039);
      EXPECT_EQ(done.scene.instants, (std::vector<double>{0, 0.01, 0.02, done.steps.back().time}));
      EXPECT_FALSE(done.stopped);
      const double end = done.scene.instants.back();
      EXPECT_NEAR(done.scene.bodies[0].motion->at(end).t[2], 0.1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_hard_motions
