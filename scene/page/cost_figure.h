// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/render/figures/figure.h"
#include "scene/file/simulation_tables.h"

namespace raygauge {

/// What accuracy costs: of several simulations of a scene the error, the proven overlap, the rise of energy
/// and the residual against the seconds, a curve for each tolerance over its steps, or where there is one
/// step for it over the tolerances. Numbers that are 0 are not drawn. Throws FigureNeedsError where there are
/// no two simulations.
Drawing draw_costs(const SimulationTables& tables, FigureSize size);

}  // namespace raygauge
