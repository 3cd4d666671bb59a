// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/simulated_tables.h"

#include <Eigen/Geometry>

#include "scene/simulation/piecewise_motion.h"

namespace raygauge {
namespace {

StateRow state_of(const Motion& motion, std::int32_t body, double t) {
  const Placement at = motion.at(t);
  const Eigen::Index n = at.t.size();
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  x.head(n) = at.t;
  R.topLeftCorner(n, n) = at.R;
  if (const auto* pieces = dynamic_cast<const PiecewiseMotion*>(&motion)) {
    v = pieces->velocity(t);
    w = pieces->spin(t);
  } else {
    const MotionBound bound = motion.bound(t, t);
    v.head(n) = bound.velocity;
    w = bound.spin;
  }
  const Eigen::Quaterniond q(R);
  return {t, body, x[0], x[1], x[2], q.w(), q.x(), q.y(), q.z(), v[0], v[1], v[2], w[0], w[1], w[2]};
}

}  // namespace

SimulationTables tables_of(const Simulation& simulation) {
  SimulationTables tables;
  for (const double t : simulation.scene.instants) {
    std::int32_t number = 0;
    for (const Body& body : simulation.scene.bodies)
      tables.states.push_back(state_of(*body.motion, number++, t));
  }
  for (const ContactRecord& c : simulation.contacts) {
    tables.contacts.push_back({c.step, c.time, c.body_a, c.body_b, c.impact ? "impact" : "contact",
                               c.point[0], c.point[1], c.point[2], c.normal[0], c.normal[1], c.normal[2],
                               c.gap, c.impulse[0], c.impulse[1], c.impulse[2]});
  }
  for (const StepRecord& s : simulation.steps) {
    tables.steps.push_back({s.time, s.substeps, s.impacts, s.contacts, s.residual, s.least_distance,
                            s.kinetic, s.potential, s.momentum[0], s.momentum[1], s.momentum[2],
                            s.angular_momentum[0], s.angular_momentum[1], s.angular_momentum[2]});
  }
  return tables;
}

}  // namespace raygauge
