// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "results/schema/column.h"

namespace raygauge {

/// A row of /simulations: one for each step of other engines, then one for each combination of dynamics.step
/// and dynamics.tolerance, the finest last.
struct SimulationRow {
  std::int32_t simulation = 0;
  double step = 0, tolerance = 0, delta = 0, seconds = 0;
  std::int64_t steps = 0, cuts = 0, impacts = 0, contacts = 0, unproven = 0;
  double residual = 0, least_distance = 0, energy_change = 0, energy_rise = 0, error = 0;
  std::string engine;
};

/// A row of /states: where a body is at an instant. In the plane z and the spins but wz are 0.
struct StateRow {
  double time = 0;
  std::int32_t body = 0;
  double x = 0, y = 0, z = 0;
  double qw = 1, qx = 0, qy = 0, qz = 0;
  double vx = 0, vy = 0, vz = 0;
  double wx = 0, wy = 0, wz = 0;
  std::int32_t simulation = 0;
};

/// A row of /contacts: a contact that carried an impulse.
struct ContactRow {
  std::int64_t step = 0;
  double time = 0;
  std::int32_t body_a = 0, body_b = 0;
  std::string kind;
  double x = 0, y = 0, z = 0;
  double nx = 0, ny = 0, nz = 0;
  double gap = 0;
  double px = 0, py = 0, pz = 0;
  std::int32_t simulation = 0;
};

/// A row of /steps.
struct StepRow {
  double time = 0;
  std::int64_t substeps = 0, impacts = 0, contacts = 0;
  double residual = 0, least_distance = 0;
  double kinetic = 0, potential = 0;
  double px = 0, py = 0, pz = 0;
  double lx = 0, ly = 0, lz = 0;
  std::int32_t simulation = 0;
};

/// What a simulation adds to a scene's results.
struct SimulationTables {
  std::vector<SimulationRow> simulations;
  std::vector<StateRow> states;
  std::vector<ContactRow> contacts;
  std::vector<StepRow> steps;
};

const std::vector<Column<SimulationRow>>& simulation_columns();
const std::vector<Column<StateRow>>& state_columns();
const std::vector<Column<ContactRow>>& contact_columns();
const std::vector<Column<StepRow>>& step_columns();

/// The tables as CSV, bodies by their names. Of one simulation without its number.
std::string simulations_csv(const SimulationTables& tables);
std::string states_csv(const SimulationTables& tables, const std::vector<std::string>& bodies);
std::string contacts_csv(const SimulationTables& tables, const std::vector<std::string>& bodies);
std::string steps_csv(const SimulationTables& tables);

}  // namespace raygauge
