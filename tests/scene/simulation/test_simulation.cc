// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "scene/simulation/piecewise_motion.h"
#include "tests/scene/simulation/reacting_scenes.h"

namespace raygauge::test_simulation {
namespace {

using namespace reacting_scenes;

const PiecewiseMotion& motion_of(const Simulation& found, std::size_t body) {
  return dynamic_cast<const PiecewiseMotion&>(*found.scene.bodies[body].motion);
}

double height(const Simulation& found, std::size_t body, double t) {
  return motion_of(found, body).at(t).t[2];
}

TEST(Simulation, free_fall_is_exact_for_any_step) {
  for (const double step : {0.3, 0.01}) {
    Reacting scene(2);
    scene.dynamics.step = step;
    scene.dynamics.gravity = v(0, 0, -9.81);
    scene.add(ball(0.1), v(1, 2, 30), 1);
    scene.dynamics.bodies[0].velocity = v(1, 0, 4);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    for (const double t : {0.1, 0.77, 2.0}) {
      const SmallVector place = motion_of(found, 0).at(t).t;
      EXPECT_NEAR(place[0], 1 + t, 1e-12);
      EXPECT_NEAR(place[2], 30 + 4 * t - 9.81 / 2 * t * t, 1e-12);
    }
    EXPECT_EQ(found.counters.contact_queries + found.counters.motion_proofs + found.counters.ball_tests, 0);
  }
}

// t_k and heights in closed form: falls from rest of the height H, then rebounds by e; the last ones last
// less than half a step of 1e-2.
TEST(Simulation, a_ball_bounces_at_the_times_and_to_the_heights_of_the_closed_form) {
  constexpr double kG = 9.81, kH = 1, kE = 0.5, kRadius = 0.1, kEnd = 1.35;
  for (const double step : {1e-2, 1e-3}) {
    Reacting scene(kEnd);
    scene.dynamics.step = step;
    scene.dynamics.gravity = v(0, 0, -kG);
    scene.dynamics.contact = ContactLaw{std::nullopt, kE};
    scene.add(ball(kRadius), v(0, 0, kH + kRadius), 1);
    scene.add(floor(), v(0, 0, 0), 0);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    const double first = std::sqrt(2 * kH / kG);
    double t = first, speed = kG * first;
    std::vector<double> times;
    for (const ContactRecord& contact : found.contacts) {
      if (contact.impact) times.push_back(contact.time);
    }
    ASSERT_EQ(times.size(), 8U) << step;
    for (const double time : times) {
      EXPECT_NEAR(time, t, 1e-6) << step;
      speed *= kE;
      const double top = t + speed / kG;
      if (top < kEnd) {
        EXPECT_NEAR(height(found, 0, top) - kRadius, speed * speed / 2 / kG, 1e-6) << step;
      }
      t += 2 * speed / kG;
    }
    for (const StepRecord& row : found.steps) EXPECT_GE(row.least_distance, -found.tolerance);
  }
}

// It stops bouncing in finite time, at t_1 (1 + e)/(1 - e) after its first contact, and then rests.
TEST(Simulation, a_bouncing_ball_comes_to_rest) {
  Reacting scene(3);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{std::nullopt, 0.5};
  scene.add(ball(0.1), v(0, 0, 1.1), 1);
  scene.add(floor(), v(0, 0, 0), 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  const double end = std::sqrt(2 / 9.81) * (1 + 0.5) / (1 - 0.5);
  EXPECT_GT(height(found, 0, end - 0.05), 0.1 + 1e-5);
  EXPECT_NEAR(height(found, 0, end + 0.05), 0.1, 2e-7);
  EXPECT_NEAR(height(found, 0, 3), 0.1, 2e-7);
  EXPECT_LT(found.steps.back().kinetic, 1e-20);
}

TEST(Simulation, with_e_1_the_energy_stays) {
  Reacting scene(2);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{std::nullopt, 1.0};
  scene.add(ball(0.1), v(0, 0, 1.1), 2);
  scene.add(floor(), v(0, 0, 0), 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_GE(found.counters.impact_problems, 2);
  for (const StepRecord& step : found.steps) EXPECT_NEAR(step.kinetic + step.potential, 2 * 9.81 * 1.1, 1e-9);
}

// Newton's law and Coulomb's together would give energy to some of these rods.
TEST(Simulation, friction_and_restitution_add_no_energy) {
  for (int k = 0; k < 60; ++k) {
    Reacting scene(0.3);
    scene.dynamics.step = 1e-2;
    scene.dynamics.contact = ContactLaw{0.4, 0.95};
    const double angle = 0.02 + 0.025 * k;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, v(0, 1, 0)).toRotationMatrix();
    scene.add(box(0.5, 0.02, 0.02), v(0, 0, 0.6), 1, R);
    scene.dynamics.bodies[0].velocity = v(k % 2 == 0 ? 3 : -3, 0, -4);
    scene.add(floor(), v(0, 0, 0), 0);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    EXPECT_GE(found.counters.impact_problems, 1) << k;
    double before = found.energy_at_start;
    for (const StepRecord& step : found.steps) {
      EXPECT_LE(step.kinetic, before * (1 + 1e-9)) << k << " at " << step.time;
      before = step.kinetic;
    }
  }
}

// The normal turns as one ball slides over the other; what is guessed of the impulse leans.
TEST(Simulation, contacts_without_friction_push_along_their_normals) {
  Reacting scene(0.5);
  scene.dynamics.step = 1e-2;
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{};
  scene.add(ball(0.3), v(0.1, 0, std::sqrt(0.36 - 0.01)), 1);
  scene.add(ball(0.3), v(0, 0, 0), 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  ASSERT_GE(found.contacts.size(), 10U);
  for (const ContactRecord& contact : found.contacts)
    EXPECT_LE(contact.impulse.cross(contact.normal).norm(), 1e-14 * contact.impulse.norm());
  EXPECT_TRUE(motion_of(found, 0).spin(0.4).isZero(1e-14));
}

TEST(Simulation, equal_balls_hand_on_their_velocity) {
  Reacting scene(1);
  scene.dynamics.contact = ContactLaw{std::nullopt, 1.0};
  for (int k = 0; k < 4; ++k) scene.add(ball(0.1), v(k == 0 ? -0.5 : 0.2 * k, 0, 0), 1);
  scene.dynamics.bodies[0].velocity = v(2, 0, 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_NEAR(motion_of(found, 3).velocity(1)[0], 2, 1e-9);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(motion_of(found, k).velocity(1).norm(), 0, 1e-9);
}

TEST(Simulation, a_box_rests_where_it_stands) {
  Reacting scene(1);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{};
  scene.add(box(0.3, 0.2, 0.1), v(0, 0, 0.1), 3);
  scene.add(floor(), v(0, 0, 0), 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_LE((motion_of(found, 0).at(1).t - scene.scene.bodies[0].motion->at(0).t).norm(), 1e-9);
  EXPECT_EQ(found.counters.friction_problems, 0);
  EXPECT_EQ(found.counters.impact_problems, 0);
  EXPECT_GT(found.counters.frictionless_problems, 0);
  for (const StepRecord& step : found.steps) {
    EXPECT_LE(step.residual, 1e-8);
    EXPECT_GE(step.least_distance, -found.tolerance);
  }
}

// What rests is not asked again; a ball that comes after 0.5 s wakes it.
TEST(Simulation, bodies_at_rest_are_left_alone_until_something_comes) {
  Reacting scene(0.4);
  scene.dynamics.step = 1e-3;
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.dynamics.contact = ContactLaw{};
  scene.add(floor(), v(0, 0, 0), 0);
  for (int k = 0; k < 3; ++k) scene.add(box(0.1, 0.1, 0.1), v(0, 0, 0.1 + 0.2 * k), 1);
  const Simulation alone = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_LE(alone.counters.contact_queries, 30);  // in 400 steps
  EXPECT_LE(alone.counters.motion_proofs, 30);
  for (std::size_t k = 1; k <= 3; ++k)
    EXPECT_EQ(motion_of(alone, k).at(0.4).t, scene.scene.bodies[k].motion->at(0).t);
  scene.scene.instants.back() = 1;
  scene.add(ball(0.1), v(1.2, 0, 0.5), 1);
  scene.dynamics.bodies.back().velocity = v(-2, 0, 9.81 * 0.25);  // at the height of the highest at 0.5 s
  const Simulation hit = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_EQ(motion_of(hit, 3).at(0.4).t, scene.scene.bodies[3].motion->at(0).t);
  EXPECT_LT(motion_of(hit, 3).at(1).t[0], -0.1);
  for (const StepRecord& step : hit.steps) EXPECT_GE(step.least_distance, -hit.tolerance);
}

// A box of 1000 m/s at a plate 1 mm thick: no step size lets it pass.
TEST(Simulation, nothing_passes_through_a_thin_plate) {
  for (const double step : {1e-2, 1e-3}) {
    Reacting scene(0.02);
    scene.dynamics.step = step;
    scene.dynamics.contact = ContactLaw{};
    scene.add(box(0.05, 0.05, 0.05), v(0.01, 0.02, 5), 1);
    scene.add(box(2, 2, 0.0005), v(0, 0, 0), 0);
    scene.dynamics.bodies[0].velocity = v(0, 0, -1000);
    scene.dynamics.bodies[0].spin = v(3, 20, 5);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    EXPECT_GT(height(found, 0, 0.02), 0);
    for (const StepRecord& row : found.steps) EXPECT_GE(row.least_distance, -found.tolerance);
  }
}

TEST(Simulation, without_contact_bodies_pass_through_each_other) {
  Reacting scene(1);
  scene.dynamics.gravity = v(0, 0, -9.81);
  scene.add(ball(0.1), v(0, 0, 1), 1);
  scene.add(floor(), v(0, 0, 0), 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
  EXPECT_NEAR(height(found, 0, 1), 1 - 9.81 / 2, 1e-12);
}

// v' = g - c v: second order in the step.
// A floor below a field of balls: each ball is near the floor and some of its neighbours.
TEST(Simulation, pairs_that_are_tested_grow_with_the_bodies_and_not_with_their_square) {
  const auto tests_of = [](int side) {
    Reacting scene(0.002);
    scene.dynamics.contact = ContactLaw{};
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) scene.add(ball(0.1), v(0.25 * x, 0.25 * y, 0.1), 1);
    }
    scene.add(floor(), v(0, 0, 0), 0);
    return simulate(scene.scene, scene.dynamics, nullptr).counters.ball_tests;
  };
  const auto few = static_cast<double>(tests_of(6)), many = static_cast<double>(tests_of(12));
  EXPECT_LT(many, 4.2 * few);
}

TEST(Simulation, damping_is_of_second_order) {
  double last = 0;
  for (const double step : {0.02, 0.01}) {
    Reacting scene(1);
    scene.dynamics.step = step;
    scene.dynamics.gravity = v(0, 0, -10);
    scene.dynamics.damping = Damping{2, 0};
    scene.add(ball(0.1), v(0, 0, 0), 1);
    const Simulation found = simulate(scene.scene, scene.dynamics, nullptr);
    const double error = std::fabs(motion_of(found, 0).velocity(1)[2] + 5 * (1 - std::exp(-2)));
    if (last > 0) {
      EXPECT_NEAR(last / error, 4, 0.2);
    }
    last = error;
    EXPECT_GT(found.counters.damped_velocities, 0);
  }
}

TEST(Simulation, what_cannot_be_simulated_is_refused) {
  Reacting scene(1);
  scene.add(floor(), v(0, 0, 0), 0);
  EXPECT_THROW(simulate(scene.scene, scene.dynamics, nullptr), InvalidParameterError);  // nothing reacts
  scene.add(ball(0.1), v(0, 0, 0.05), 1);
  scene.dynamics.contact = ContactLaw{};
  EXPECT_THROW(simulate(scene.scene, scene.dynamics, nullptr), InvalidParameterError);  // they overlap
  scene.dynamics.contact = ContactLaw{std::nullopt, 1.5};
  EXPECT_THROW(simulate(scene.scene, scene.dynamics, nullptr), InvalidParameterError);
  scene.dynamics.contact = ContactLaw{-1.0, std::nullopt};
  EXPECT_THROW(simulate(scene.scene, scene.dynamics, nullptr), InvalidParameterError);
}

TEST(Simulation, spins_of_more_than_a_thousand_radians_a_step_are_refused_in_one_line) {
  Reacting scene(0.002);
  scene.dynamics.step = 1e-3;
  scene.add(box(0.1, 0.2, 0.3), v(0, 0, 0), 1);
  scene.dynamics.bodies[0].spin = v(0, 0, 9.9e5);
  EXPECT_NO_THROW(simulate(scene.scene, scene.dynamics, nullptr));
  scene.dynamics.bodies[0].spin = v(0, 0, 1e9);
  try {
    simulate(scene.scene, scene.dynamics, nullptr);
    FAIL();
  } catch (const InvalidParameterError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "dynamics: body 'body0' turns by 1e+06 radians in a step of 0.001 s; at most 1000 can be proven, in "
        "shorter steps");
  }
}

}  // namespace
}  // namespace raygauge::test_simulation
