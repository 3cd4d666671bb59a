// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_ladder.h"

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

double newton_and_paths(const FrictionProblem& problem, std::size_t paths, Eigen::VectorXd& r) {
  constexpr std::array<double, 2> kRates = {0.3, 0.7};
  double residual = improve_friction(problem, r);
  for (std::size_t k = 0; k < paths && residual > solved_friction(problem.mu.size()); ++k) {
    Eigen::VectorXd trial = r;
    follow_smoothed_friction(problem, kRates.at(k), trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

// By passes, and Newton's method from where they or the step before have ended. Of many contacts a matrix is
// factorized only where their residual is large, as in towers.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r) {
  constexpr double kEnough = 1e-10;           // before a matrix of few contacts is factorized
  constexpr double kRough = 1e-5;             // before one of more than ...
  constexpr std::size_t kSomeContacts = 60;   // ... so many
  constexpr std::size_t kMostContacts = 150;  // of paths
  const std::size_t count = island.contacts.size();
  const bool few = count <= kFewContacts;
  const Eigen::VectorXd guess = r;
  const double passed = pass_over_friction(island, island.bound_of_W(), r);
  const double solved = solved_friction(count);
  if (passed <= (few ? kEnough : count <= kSomeContacts ? solved : kRough)) return passed;
  const FrictionProblem problem = island.dense();
  double residual = friction_residual(problem, r);
  if (few) take_better(problem, guess, residual, r);
  if (residual > solved) residual = newton_and_paths(problem, few ? 2 : count <= kMostContacts ? 1 : 0, r);
  if (residual > (few ? solved : kRough) && friction != nullptr) {
    Eigen::VectorXd trial = guess;
    friction->solve(problem, trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

}  // namespace raygauge
