// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/simulation.h"
#include "scene/file/simulation_tables.h"

namespace raygauge {

/// Adds a simulation, its bodies at the instants of the scene, its contacts and steps; `engine`: whose it is.
void add_simulation(const Simulation& simulation, const Dynamics& dynamics, double seconds,
                    const std::string& engine, SimulationTables& tables);

/// Once all are added: how far bodies are from where they are in the last simulation.
void compare_with_finest(SimulationTables& tables);

}  // namespace raygauge
