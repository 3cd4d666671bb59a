// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_ladder.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/simulation/friction_newton.h"
#include "scene/simulation/friction_passes.h"
#include "scene/simulation/friction_smoothing.h"

namespace raygauge {
namespace {

// Newton's method from `trial`: r and its residual are of the better one.
void take_better(const FrictionProblem& problem, Eigen::VectorXd trial, double& residual,
                 Eigen::VectorXd& r) {
  const double found = improve_friction(problem, trial);
  if (!(found < residual)) return;
  residual = found;
  r = std::move(trial);
}

}  // namespace

double newton_and_paths(const FrictionProblem& problem, const Eigen::VectorXd& start, std::size_t paths,
                        Eigen::VectorXd& r) {
  constexpr std::array<double, 2> kRates = {0.3, 0.7};
  double residual = improve_friction(problem, r);
  for (std::size_t k = 0; k < paths && residual > solved_friction(problem.mu.size()); ++k) {
    Eigen::VectorXd trial = start;
    follow_smoothed_friction(problem, kRates.at(k), trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

namespace {

// The residual above which a matrix of so many contacts is factorized: above 150 that takes a second.
double rough_friction(std::size_t contacts) {
  if (contacts <= kFewContacts) return 1e-10;
  if (contacts <= 60) return solved_friction(contacts);
  return contacts <= 150 ? 1e-7 : 1e-3;
}

}  // namespace

// By passes, and Newton's method from where they or the step before have ended. Of many contacts a matrix is
// factorized only where their residual is large, as in towers that begin to stand.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r) {
  const std::size_t count = island.contacts.size();
  const bool few = count <= kFewContacts;
  const double solved = solved_friction(count), rough = rough_friction(count);
  const Eigen::VectorXd guess = r;
  const double passed = pass_over_friction(island, island.bound_of_W(), r);
  if (passed <= rough) return passed;
  const FrictionProblem problem = island.dense();
  double residual = friction_residual(problem, r);
  if (few) take_better(problem, guess, residual, r);
  if (residual > solved) residual = newton_and_paths(problem, guess, few ? 2 : 1, r);
  if (residual > std::max(solved, rough) && friction != nullptr) {
    Eigen::VectorXd trial = guess;
    friction->solve(problem, trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

}  // namespace raygauge
