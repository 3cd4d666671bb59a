// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// Of so many contacts a matrix is soon factorized.
inline constexpr std::size_t kFewContacts = 24;

/// The residual from which on a friction problem is solved.
inline constexpr double kSolvedFriction = 1e-9;

/// Passes over the contacts of an island, each solved by itself while the others stay (Gauss and Seidel's
/// method), extrapolated by Anderson's method (1965) from the last passes; then, of many contacts, with a
/// block of those that keep from their law, solved together; then without. From a first guess r until
/// island_residual() is at most 1e-10, or no longer falls. Returns it; `bound` is bound_of_W().
double pass_over_friction(const FrictionIsland& island, double bound, Eigen::VectorXd& r);

}  // namespace raygauge
