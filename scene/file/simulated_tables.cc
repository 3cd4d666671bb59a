// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/simulated_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/simulation/moving_state.h"

#include "scene/simulation/piecewise_motion.h"

namespace raygauge {
namespace {

StateRow state_of(const Motion& motion, std::int32_t body, double t, std::int32_t number) {
  const MovingState at = state_at(motion, t);
  const Eigen::Vector3d &x = at.place, &v = at.velocity, &w = at.spin;
  const Eigen::Quaterniond& q = at.rotation;
  return {t, body, x[0], x[1], x[2], q.w(), q.x(), q.y(), q.z(), v[0], v[1], v[2], w[0], w[1], w[2], number};
}

SimulationRow row_of(const Simulation& simulation, const Dynamics& dynamics, double seconds) {
  SimulationRow row;
  row.step = dynamics.step;
  row.tolerance = dynamics.tolerance;
  row.delta = simulation.tolerance;
  row.seconds = seconds;
  row.error = std::numeric_limits<double>::quiet_NaN();
  double energy = simulation.energy_at_start, least = energy;
  for (const StepRecord& step : simulation.steps) {
    ++row.steps;
    row.cuts += step.substeps - 1;
    row.impacts += step.impacts;
    row.contacts += step.contacts;
    if (!(step.residual <= row.residual)) row.residual = step.residual;  // also what is not known
    const bool proven = std::isfinite(step.least_distance);
    row.unproven += proven ? 0 : 1;
    if (proven) row.least_distance = std::min(row.least_distance, step.least_distance);
    energy = step.kinetic + step.potential;
    row.energy_rise = std::max(row.energy_rise, energy - least);
    least = std::min(least, energy);
  }
  row.energy_change = energy - simulation.energy_at_start;
  return row;
}

}  // namespace

void add_simulation(const Simulation& simulation, const Dynamics& dynamics, double seconds,
                    const std::string& engine, SimulationTables& tables) {
  const auto number = static_cast<std::int32_t>(tables.simulations.size());
  tables.simulations.push_back(row_of(simulation, dynamics, seconds));
  tables.simulations.back().simulation = number;
  tables.simulations.back().engine = engine;
  for (const double t : simulation.scene.instants) {
    std::int32_t body = 0;
    for (const Body& one : simulation.scene.bodies)
      tables.states.push_back(state_of(*one.motion, body++, t, number));
  }
  for (const ContactRecord& c : simulation.contacts) {
    tables.contacts.push_back({c.step, c.time, c.body_a, c.body_b, c.impact ? "impact" : "contact",
                               c.point[0], c.point[1], c.point[2], c.normal[0], c.normal[1], c.normal[2],
                               c.gap, c.impulse[0], c.impulse[1], c.impulse[2], number});
  }
  for (const StepRecord& s : simulation.steps) {
    tables.steps.push_back({s.time, s.substeps, s.impacts, s.contacts, s.residual, s.least_distance,
                            s.kinetic, s.potential, s.momentum[0], s.momentum[1], s.momentum[2],
                            s.angular_momentum[0], s.angular_momentum[1], s.angular_momentum[2], number});
  }
}

void compare_with_finest(SimulationTables& tables) {
  if (tables.simulations.size() < 2) return;
  const std::size_t each = tables.states.size() / tables.simulations.size();
  const std::size_t finest = tables.states.size() - each;
  for (std::size_t k = 0; k < finest; ++k) {
    const StateRow &here = tables.states[k], &there = tables.states[finest + k % each];
    const double error = std::hypot(here.x - there.x, here.y - there.y, here.z - there.z);
    double& most = tables.simulations[static_cast<std::size_t>(here.simulation)].error;
    most = k % each == 0 ? error : std::max(most, error);
  }
}

}  // namespace raygauge
