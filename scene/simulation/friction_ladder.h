// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// The impulses of an island whose contacts have friction, from those of the step before, by the quickest way
/// that ends. `friction`: a solver that is asked where others do not, or null. Returns island_residual();
/// `roughly`: where that of many contacts is at most tuned::kRoughFriction, no more is done.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r,
                      bool roughly = false);

}  // namespace raygauge
