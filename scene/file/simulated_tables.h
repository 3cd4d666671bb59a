// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/scene/simulation.h"
#include "scene/file/simulation_tables.h"

namespace raygauge {

/// A simulation as tables: bodies at the instants of the scene, contacts, steps.
SimulationTables tables_of(const Simulation& simulation);

}  // namespace raygauge
