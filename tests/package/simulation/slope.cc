// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A block slides down a slope of 30 degrees for a second: (sin - μ cos) g/2 is its way in closed form. Steps
// of 1 ms are of first order: 1e-3 of it.
#include <raygauge/raygauge.h>
#include <raygauge/simulation.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace {

using Vector = Eigen::Vector3d;

std::shared_ptr<const raygauge::ConvexSet> box(const Vector& low, const Vector& high) {
  return std::make_shared<raygauge::Box>(low, high);
}

std::shared_ptr<raygauge::StaticMotion> place(const Vector& at) {
  return std::make_shared<raygauge::StaticMotion>(raygauge::make_placement(Eigen::Matrix3d::Identity(), at));
}

}  // namespace

int main() {
  const auto shape = box({-0.3, -0.2, -0.1}, {0.3, 0.2, 0.1});
  raygauge::Scene scene;
  scene.instants = {0, 1};
  scene.bodies = {raygauge::make_body("block", {shape}, place({0, 0, 0.1})),
                  raygauge::make_body("slope", {box({-20, -20, -1}, {20, 20, 0})}, place({0, 0, 0}))};

  raygauge::Dynamics dynamics;
  const double angle = std::acos(-1) / 6;
  dynamics.gravity = 9.81 * Vector(std::sin(angle), 0, -std::cos(angle));  // turned instead of the slope
  dynamics.contact = raygauge::ContactLaw{};
  dynamics.bodies.resize(2);  // the slope has no mass: it stands
  const raygauge::Moments moments = raygauge::moments_of(*shape);
  dynamics.bodies[0].mass = 3;
  dynamics.bodies[0].inertia = 3 / moments.measure * moments.inertia();

  std::unique_ptr<raygauge::FrictionSolver> friction;
#ifdef FRICTION
  dynamics.contact->friction = 0.5;
  friction = raygauge::siconos_friction();
#endif
  const raygauge::Simulation found = raygauge::simulate(scene, dynamics, friction.get());
  double least = 0;
  for (const raygauge::StepRecord& step : found.steps) least = std::min(least, step.least_distance);
  const auto& motion = *found.scene.bodies[0].motion;
  const double slid = motion.at(1).t[0] - motion.at(0).t[0];
  const double exact =
      (std::sin(angle) - dynamics.contact->friction.value_or(0) * std::cos(angle)) * 9.81 / 2;
  std::cout << "slid " << slid << " (exact: " << exact << "), never deeper than " << -least << '\n';
  return least < -found.tolerance || std::abs(slid - exact) > 2e-3 * exact ? 1 : 0;
}
