// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `glpk_primal` and `glpk_dual`: the linear program of Example 2 by the primal and the dual simplex of
/// GLPK. Parameters (docs/baselines.md has the reasons):
///
///     presolve  false                  GLPK's presolver
///     scale     false                  glp_scale_prob(GLP_SF_AUTO) when the model is loaded
///     basis     "standard"             first basis: "standard" (glp_std_basis) or "advanced" (glp_adv_basis)
///
/// A request's tolerance ε becomes tol_bnd = tol_dj = ε/10, clamped to [1e-12, 1e-3]; at ε = 1e-6 these are
/// GLPK's own defaults. A time limit is rounded up to milliseconds.
void register_glpk_methods(MethodRegistry& registry);

/// "5.0", of the library that is linked.
const char* glpk_version();

}  // namespace raygauge
