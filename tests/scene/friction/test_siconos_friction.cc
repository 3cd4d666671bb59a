// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "raygauge/queries/object_distance.h"
#include "scene/simulation/piecewise_motion.h"
#include "tests/scene/simulation/reacting_scenes.h"

namespace raygauge::test_siconos_friction {
namespace {

using namespace reacting_scenes;

constexpr double kG = 9.81, kSlope = 0.4;  // radians

TEST(SiconosFriction, one_contact_sticks_or_slides_as_coulomb_says) {
  const auto friction = siconos_friction();
  FrictionProblem problem{Eigen::Matrix3d::Identity(), Eigen::Vector3d(-1, 0.3, 0), {0.5}};
  Eigen::VectorXd r = Eigen::VectorXd::Zero(3);
  friction->solve(problem, r);
  EXPECT_LE((r - Eigen::Vector3d(1, -0.3, 0)).norm(), 1e-9);
  problem.q[1] = 3;
  friction->solve(problem, r);
  EXPECT_LE((r - Eigen::Vector3d(1, -0.5, 0)).norm(), 1e-9);
  EXPECT_LE(friction_residual(problem, r), 1e-9);
  EXPECT_GT(friction_residual(problem, Eigen::Vector3d(1, -0.4, 0)), 1e-3);
}

// The signed distance of the first two bodies, computed anew at many times, between the steps too.
void expect_no_closer(const Simulation& found, double least, double to) {
  ObjectDistanceSolver solver;
  const Ball unit(v(0, 0, 0), 1);
  const Body &a = found.scene.bodies[0], &b = found.scene.bodies[1];
  const auto pose = [](const Body& body, double t) {
    const Placement at = body.motion->at(t);
    return Pose(Eigen::MatrixXd(at.R), Eigen::VectorXd(at.t));
  };
  constexpr int kLooks = 5000;
  double closest = 1;
  for (int k = 0; k < kLooks; ++k) {
    const double t = to * (k + 0.37) / kLooks;
    const Pose at_a = pose(a, t), at_b = pose(b, t);
    const ObjectDistance& seen =
        solver.solve({*a.parts[0].set, at_a}, {*b.parts[0].set, at_b}, unit, ObjectEffects::depth);
    closest = std::min(closest, seen.signed_distance());
  }
  EXPECT_GE(closest, least);
  EXPECT_LT(closest, 1e-6);  // they do touch
}

// A block on a slope of angle kSlope: gravity is turned instead of the plane.
Simulation block_on_slope(double mu, double step, double to, FrictionSolver* friction) {
  Reacting scene(to);
  scene.dynamics.step = step;
  scene.dynamics.gravity = kG * v(std::sin(kSlope), 0, -std::cos(kSlope));
  scene.dynamics.contact = ContactLaw{mu, std::nullopt};
  scene.add(box(0.3, 0.2, 0.1), v(0, 0, 0.1), 3);
  scene.add(floor(), v(0, 0, 0), 0);
  return simulate(scene.scene, scene.dynamics, friction);
}

double slid(const Simulation& found, double t) { return found.scene.bodies[0].motion->at(t).t[0]; }

TEST(SiconosFriction, a_block_sticks_just_above_the_angle_of_friction) {
  const auto friction = siconos_friction();
  const Simulation found = block_on_slope(std::tan(kSlope) * 1.01, 1e-2, 5, friction.get());
  EXPECT_LE((found.scene.bodies[0].motion->at(5).t - found.scene.bodies[0].motion->at(0).t).norm(), 1e-9);
  for (const StepRecord& step : found.steps) {
    EXPECT_LE(step.residual, 1e-8);
    EXPECT_GE(step.least_distance, -found.tolerance);
  }
}

TEST(SiconosFriction, just_below_it_slides_as_computed_and_converges) {
  const auto friction = siconos_friction();
  const double mu = std::tan(kSlope) * 0.9;
  const double exact = kG * (std::sin(kSlope) - mu * std::cos(kSlope)) / 2;  // after one second
  const double coarse = slid(block_on_slope(mu, 2e-3, 1, friction.get()), 1);
  const double fine = slid(block_on_slope(mu, 1e-3, 1, friction.get()), 1);
  EXPECT_NEAR(fine, exact, 0.01 * exact);
  EXPECT_NEAR((coarse - exact) / (fine - exact), 2, 0.1);
}

// A ball that slides at first rolls from the time 2 v/(7 μ g) on, with 5/7 of its velocity.
TEST(SiconosFriction, a_ball_slips_until_it_rolls) {
  const auto friction = siconos_friction();
  Reacting scene(1);
  scene.dynamics.gravity = v(0, 0, -kG);
  scene.dynamics.contact = ContactLaw{0.2, std::nullopt};
  scene.add(ball(0.1), v(0, 0, 0.1), 1);
  scene.add(floor(), v(0, 0, 0), 0);
  scene.dynamics.bodies[0].velocity = v(2, 0, 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, friction.get());
  const auto& motion = dynamic_cast<const PiecewiseMotion&>(*found.scene.bodies[0].motion);
  const double rolls = 2 * 2 / (7 * 0.2 * kG);
  EXPECT_NEAR(motion.velocity(rolls / 2)[0], 2 - 0.2 * kG * rolls / 2, 5e-3);
  EXPECT_NEAR(motion.velocity(1)[0], 10.0 / 7, 1e-2);
  EXPECT_NEAR(motion.spin(1)[1] * 0.1, motion.velocity(1)[0], 1e-6);
}

TEST(SiconosFriction, a_box_falls_tumbles_and_comes_to_rest) {
  const auto friction = siconos_friction();
  Reacting scene(4);
  scene.dynamics.step = 5e-3;
  scene.dynamics.tolerance = 1e-4;
  scene.dynamics.gravity = v(0, 0, -kG);
  scene.dynamics.contact = ContactLaw{0.5, 0.3};
  scene.add(box(0.3, 0.2, 0.1), v(0, 0, 1), 3,
            Eigen::AngleAxisd(0.5, v(1, 2, 3).normalized()).toRotationMatrix());
  scene.add(floor(), v(0, 0, 0), 0);
  scene.dynamics.bodies[0].spin = v(2, 3, 1);
  const Simulation found = simulate(scene.scene, scene.dynamics, friction.get());
  double energy = found.steps.front().kinetic + found.steps.front().potential;
  for (const StepRecord& step : found.steps) {
    EXPECT_GE(step.least_distance, -found.tolerance) << step.time;
    EXPECT_LE(step.kinetic + step.potential, energy * (1 + 1e-6)) << step.time;
    energy = step.kinetic + step.potential;
  }
  EXPECT_LT(found.steps.back().kinetic, 1e-8);
  expect_no_closer(found, -found.tolerance, 4);
}

// Cubes on each other, each a little beside the one below.
Simulation tower(int cubes, double to, FrictionSolver* friction) {
  Reacting scene(to);
  scene.dynamics.step = 1e-2;
  scene.dynamics.gravity = v(0, 0, -kG);
  scene.dynamics.contact = ContactLaw{0.5, std::nullopt};
  for (int k = 0; k < cubes; ++k)
    scene.add(box(0.5, 0.5, 0.5), v(0.02 * (k % 5), 0.01 * (k % 5), 0.5 + k), 1);
  scene.add(floor(), v(0, 0, 0), 0);
  return simulate(scene.scene, scene.dynamics, friction);
}

void expect_standing(const Simulation& found, int cubes, double to) {
  for (int k = 0; k < cubes; ++k) {
    const Body& cube = found.scene.bodies[static_cast<std::size_t>(k)];
    EXPECT_LE((cube.motion->at(to).t - cube.motion->at(0).t).norm(), 1e-6) << k;
  }
  for (const StepRecord& step : found.steps) {
    EXPECT_GE(step.least_distance, -found.tolerance);
    EXPECT_LE(step.residual, 1e-8);
  }
}

TEST(SiconosFriction, a_stack_of_cubes_stands) {
  const auto friction = siconos_friction();
  expect_standing(tower(5, 1, friction.get()), 5, 1);
}

TEST(SiconosFriction, a_tower_of_thirty_cubes_stands) {
  const auto friction = siconos_friction();
  expect_standing(tower(30, 0.5, friction.get()), 30, 0.5);
}

TEST(SiconosFriction, in_the_plane_a_box_slides_on_a_floor) {
  const auto friction = siconos_friction();
  Reacting scene(1);
  scene.dynamics.gravity = v(0, -kG, 0);
  scene.dynamics.contact = ContactLaw{0.2, std::nullopt};
  const auto rectangle = [](double x, double y) {
    return std::make_shared<Box>(Eigen::Vector2d(-x, -y), Eigen::Vector2d(x, y));
  };
  const Shape box = rectangle(0.3, 0.1), ground = rectangle(20, 1);
  const auto at = [](double x, double y) {
    return std::make_shared<StaticMotion>(make_placement(Eigen::Matrix2d::Identity(), Eigen::Vector2d(x, y)));
  };
  scene.scene.bodies = {make_body("box", {box}, at(0, 0.1)), make_body("ground", {ground}, at(0, -1))};
  const Moments moments = moments_of(*box);
  scene.dynamics.bodies.resize(2);
  scene.dynamics.bodies[0].mass = moments.measure;
  scene.dynamics.bodies[0].inertia = moments.inertia();
  scene.dynamics.bodies[0].velocity = v(1, 0, 0);
  const Simulation found = simulate(scene.scene, scene.dynamics, friction.get());
  const SmallVector end = found.scene.bodies[0].motion->at(1).t;
  EXPECT_NEAR(end[0], 1 / (2 * 0.2 * kG), 1e-3);
  EXPECT_NEAR(end[1], 0.1, 1e-6);
}

}  // namespace
}  // namespace raygauge::test_siconos_friction
