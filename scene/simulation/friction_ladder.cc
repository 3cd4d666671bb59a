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

// The residual above which a dense matrix of so many contacts is factorized, which above 150 takes a second:
// soon where nothing is known of a step before, as in towers that begin to stand.
double rough_friction(std::size_t contacts, bool first) {
  if (contacts <= 60 || (contacts <= 150 && first)) return enough_friction(contacts, first);
  return contacts <= 150 ? 1e-7 : 1e-3;
}

/// Ways to the impulses of an island, of which the best is kept.
class Ladder {
 public:
  Ladder(const FrictionIsland& island, double bound, double enough, double residual, Eigen::VectorXd& r)
      : island_(island), bound_(bound), enough_(enough), newton_(island, bound), residual_(residual), r_(r) {}

  double residual() const { return residual_; }
  bool is_solved() const { return residual_ <= enough_; }

  void newton(Eigen::VectorXd trial) {
    if (is_solved()) return;
    const double found = newton_.improve(trial);
    if (!(found < residual_)) return;
    residual_ = found;
    r_ = std::move(trial);
  }

  void soften(const Eigen::VectorXd& start) {
    if (!is_solved()) residual_ = newton_.stiffen(start, residual_, r_);
  }

  // Newton's method from where so many passes lead, and more.
  void relax(Eigen::VectorXd start) {
    constexpr int kRounds = 6;
    for (int round = 0, passes = 5; round < kRounds && !is_solved(); ++round, passes = passes * 3 / 2) {
      relax_friction(island_, passes, start);
      newton(start);
    }
  }

  void pass_with_block(Eigen::VectorXd start) {
    const double found = raygauge::pass_with_block(island_, bound_, enough_, start);
    if (!(found < residual_)) return;
    residual_ = found;
    r_ = std::move(start);
  }

  void pass_patiently(Eigen::VectorXd start) {
    if (is_solved()) return;
    raygauge::pass_patiently(island_, bound_, start);
    newton(std::move(start));
  }

  // The end of a path of smoothed problems, and of another one.
  void follow_paths(std::size_t paths, const FrictionProblem& problem) {
    constexpr std::array<double, 2> kRates = {0.3, 0.7};
    for (std::size_t k = 0; k < paths && !is_solved(); ++k) {
      Eigen::VectorXd trial = Eigen::VectorXd::Zero(r_.size());
      follow_smoothed_friction(problem, kRates.at(k), trial);
      newton(trial);
    }
  }

 private:
  const FrictionIsland& island_;
  double bound_, enough_;
  IslandNewton newton_;
  double residual_;
  Eigen::VectorXd& r_;
};

}  // namespace

// The quickest way that ends, by how many there are: few are solved by Newton's method from the step before
// or from where passes lead; of many, some that turn with each other hold up the passes, and those alone are.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r) {
  const std::size_t count = island.contacts.size();
  const bool few = count <= kFewContacts, first = r.isZero(0);
  const double bound = island.bound_of_W(), enough = enough_friction(count, first);
  const Eigen::VectorXd guess = r;
  const double passed = pass_over_friction(island, bound, r);
  if (passed <= enough) return passed;
  Ladder ladder(island, bound, enough, passed, r);
  const Eigen::VectorXd passes = r;
  if (few)
    ladder.newton(guess);
  else
    ladder.pass_with_block(passes);
  ladder.newton(few ? passes : Eigen::VectorXd(r));
  ladder.soften(guess);
  if (!few) ladder.pass_patiently(r);
  ladder.relax(guess);
  if (few) ladder.pass_patiently(passes);
  if (ladder.residual() <= rough_friction(count, first)) return ladder.residual();
  const FrictionProblem problem = island.dense();
  ladder.follow_paths(few ? 2 : 1, problem);
  if (!ladder.is_solved() && friction != nullptr) {
    Eigen::VectorXd trial = guess;
    friction->solve(problem, trial);
    ladder.newton(trial);
  }
  return ladder.residual();
}

}  // namespace raygauge
