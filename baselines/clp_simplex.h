// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `clp_primal` and `clp_dual`: the linear program of Example 2 by the primal and the dual simplex of
/// COIN-OR Clp. Parameters (docs/baselines.md has the reasons):
///
///     presolve  false     Clp's presolver, through initialSolve
///     scaling   "auto"    Clp's own default; or "off", "equilibrium", "geometric"
///
/// A request's tolerance ε becomes the primal and the dual tolerance ε/10, clamped to [1e-12, 1e-3]; at
/// ε = 1e-6 these are Clp's own defaults. A time limit is wall time.
void register_clp_methods(MethodRegistry& registry);

/// "1.17.6", of the headers compiled against.
const char* clp_version();

}  // namespace raygauge
