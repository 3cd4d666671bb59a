// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// Newton's method from the end of a path of smoothed problems that begins at `start`, and of another one: of
/// so many `paths` at most, 0 to 2, until it is solved. `residual` is that of r, which is replaced where one
/// is better. Returns its residual.
double follow_friction_paths(const FrictionProblem& problem, const Eigen::VectorXd& start, std::size_t paths,
                             double residual, Eigen::VectorXd& r);

/// Newton's method from the end of a path of softer problems that begins at `start`: W + ε 1 with ε that
/// falls from 1e-2 to nothing, relative to W. Where bodies stick at points that their gaps would move apart
/// or together, impulses between these grow until one slips; soft contacts have bounded ones, and so the
/// path tells which. `residual` is that of r, which is replaced where the end is better. Returns its
/// residual.
double stiffen_contacts(const FrictionProblem& problem, const Eigen::VectorXd& start, double residual,
                        Eigen::VectorXd& r);

/// The impulses of an island whose contacts have friction, from those of the step before, by the quickest way
/// that ends. `friction`: a solver that is asked where others do not, or null. Returns the residual.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r);

}  // namespace raygauge
