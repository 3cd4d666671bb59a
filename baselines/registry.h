// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds the competitors this build was configured with: `glpk_primal`, `glpk_dual` (RAYGAUGE_WITH_GLPK),
/// `clp_primal`, `clp_dual` (RAYGAUGE_WITH_CLP), `exact` (RAYGAUGE_WITH_EXACT), `nlopt_slsqp`
/// (RAYGAUGE_WITH_NLOPT), `fcl_libccd`, `fcl_indep` (RAYGAUGE_WITH_FCL).
void register_baselines(MethodRegistry& registry);

/// The solvers of this build and the versions that are linked, for provenance: {{"GLPK", "5.0"}, …}.
std::vector<std::pair<std::string, std::string>> solver_versions();

}  // namespace raygauge
