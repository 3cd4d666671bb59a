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

// The residual above which a matrix of so many contacts is factorized, which above 150 takes a second: soon
// where nothing is known of a step before, as in towers that begin to stand.
double rough_friction(std::size_t contacts, bool first) {
  if (contacts <= kFewContacts) return 1e-10;
  if (contacts <= 60 || (contacts <= 150 && first)) return enough_friction(contacts, first);
  return contacts <= 150 ? 1e-7 : 1e-3;
}

// Newton's method from `trial`: r and its residual are of the better one.
void take_better(const FrictionProblem& problem, Eigen::VectorXd trial, double& residual,
                 Eigen::VectorXd& r) {
  const double found = improve_friction(problem, trial);
  if (!(found < residual)) return;
  residual = found;
  r = std::move(trial);
}

}  // namespace

double follow_friction_paths(const FrictionProblem& problem, const Eigen::VectorXd& start, std::size_t paths,
                             double residual, Eigen::VectorXd& r) {
  constexpr std::array<double, 2> kRates = {0.3, 0.7};
  for (std::size_t k = 0; k < paths && residual > kSolvedFriction; ++k) {
    Eigen::VectorXd trial = start;
    follow_smoothed_friction(problem, kRates.at(k), trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

double stiffen_contacts(const FrictionProblem& problem, const Eigen::VectorXd& start, double residual,
                        Eigen::VectorXd& r) {
  constexpr double kSoftest = 1e-2, kStiffer = 0.1;  // of W
  constexpr int kSteps = 10;
  double softness = kSoftest * problem.W.diagonal().maxCoeff();
  FrictionProblem soft = problem;
  Eigen::VectorXd trial = start;
  for (int step = 0; step < kSteps; ++step) {
    soft.W.diagonal() = problem.W.diagonal().array() + softness;
    if (improve_friction(soft, trial, 0) > kSolvedFriction) break;
    if (friction_residual(problem, trial) <= kSolvedFriction) break;
    softness *= kStiffer;
  }
  const double found = improve_friction(problem, trial, 0);
  if (!(found < residual)) return residual;
  r = std::move(trial);
  return found;
}

// By passes, and Newton's method from where they or the step before have ended, or from nothing.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r) {
  const std::size_t count = island.contacts.size();
  const bool few = count <= kFewContacts;
  const double rough = rough_friction(count, r.isZero(0));
  const Eigen::VectorXd guess = r;
  const double passed = pass_over_friction(island, island.bound_of_W(), r);
  if (passed <= rough) return passed;
  const FrictionProblem problem = island.dense();
  const Eigen::VectorXd passes = r, nothing = Eigen::VectorXd::Zero(r.size());
  double residual = friction_residual(problem, r);
  take_better(problem, passes, residual, r);
  if (residual > kSolvedFriction) take_better(problem, guess, residual, r);
  if (residual > kSolvedFriction && few) take_better(problem, nothing, residual, r);
  if (residual > kSolvedFriction) residual = stiffen_contacts(problem, passes, residual, r);
  residual = follow_friction_paths(problem, guess, few ? 2 : 1, residual, r);
  if (residual > std::max(kSolvedFriction, rough) && friction != nullptr) {
    Eigen::VectorXd trial = guess;
    friction->solve(problem, trial);
    take_better(problem, trial, residual, r);
  }
  return residual;
}

}  // namespace raygauge
