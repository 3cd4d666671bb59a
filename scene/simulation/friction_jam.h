// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// The residual above which a problem may have no solution, and is looked into.
inline constexpr double kUnsolvable = 1e-6;

/// Impulses r, each in the cone of its contact, that leave all bodies as they are, Σ A r = 0, but of which
/// the velocities asked for would take energy, rᵀq < 0: a body that is clamped between others that close.
/// They may grow without end, and no velocities have u_n >= μ|u_t| at all contacts: proven of all that are up
/// to 10^4 times as fast as |q| and as those that come nearest to it. Of bodies without friction the problem
/// then has no solution. Nothing, if there are none, or none was found.
std::optional<Eigen::VectorXd> jam_of(const FrictionIsland& island);

}  // namespace raygauge
