// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/scene/friction.h"

namespace raygauge {

inline constexpr int kRoundsOfNewton = 6;

/// Newton's method on the equations of Alart and Curnier (1991), with ρ = 1/‖W of the contact‖ and then 1e4
/// times that, by which bodies that slip by little are told from such that stick:
///
///     r_n = a,  a = max(0, r_n - ρ u_n),     r_t = the point of the disc of radius μ a nearest to r_t - ρ
///     u_t.
///
/// From a first guess r that knows which contacts stick, slide and open it ends in a few steps of a dense
/// factorization each; steps that do not come closer end it. Then so many `rounds` more, each from where
/// passes over the contacts lead. Returns friction_residual() of r on return, which is never above that of r
/// on entry.
double improve_friction(const FrictionProblem& problem, Eigen::VectorXd& r, int rounds = kRoundsOfNewton);

}  // namespace raygauge
