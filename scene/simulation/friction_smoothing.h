// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/simulation.h"

namespace raygauge {

/// Friction by a path of smoothed problems. With y = (μ r_n, r_t) and De Saxcé's z = (u_n/μ + |u_t|, u_t) of
/// each contact the law is y, z in the Lorentz cone L, y ∘ z = 0 in its Jordan algebra. In its place
///
///     y + z - (y ∘ y + z ∘ z + 2 τ² e)^(1/2) = 0,   that is y ∘ z = τ² e,
///
/// (Fukushima, Luo and Tseng 2002) is solved by Newton's method, a dense factorization a step, for τ that
/// fall to 1e-9 of the size of the problem. It needs no guess which contacts stick, slide or open. Returns
/// friction_residual() of r, which on entry does not matter.
double follow_smoothed_friction(const FrictionProblem& problem, double rate, Eigen::VectorXd& r);

}  // namespace raygauge
