// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_ladder.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "scene/simulation/friction_interior.h"
#include "scene/simulation/friction_newton.h"
#include "scene/simulation/friction_passes.h"
#include "scene/simulation/tuning.h"

namespace raygauge {
namespace {

/// Where Newton's method begins anew, and how steep its equations are: gentle ones see far, steep ones tell
/// near things apart.
struct Rung {
  enum class From : std::uint8_t { passes, best, interior };

  From from;
  double share;  // of those impulses
  double steepness;
};

// In the order of what they solve in a millisecond.
using From = Rung::From;
constexpr Rung kRungs[] = {{From::interior, 1, 300}, {From::interior, 1, 30},  {From::best, 1, 1000},
                           {From::best, 1, 10},      {From::best, 1, 100},     {From::passes, 0.5, 30},
                           {From::passes, 1, 30},    {From::best, 1, 3e4},     {From::passes, 2, 1},
                           {From::best, 1, 300},     {From::best, 1, 1},       {From::best, 1, 1e4},
                           {From::passes, 0, 1},     {From::passes, 0.5, 0.1}, {From::best, 1, 3000},
                           {From::best, 1, 1e5},     {From::passes, 1, 10}};

// The residual above which a dense matrix of so many contacts is factorized, which above 150 takes a second.
double hard_friction(std::size_t contacts, bool first) {
  return contacts <= 150 ? enough_friction(contacts, first) : 1e-3;
}

/// Ways to the impulses of an island, of which the best is kept.
class Ladder {
 public:
  Ladder(const FrictionIsland& island, double bound, double enough, double residual, Eigen::VectorXd& r)
      : island_(island), bound_(bound), enough_(enough), newton_(island, bound), residual_(residual), r_(r) {}

  double residual() const { return residual_; }
  bool is_solved() const { return residual_ <= enough_; }

  // From where it is, by a few rounds while they gain.
  void newton_briefly() {
    Eigen::VectorXd trial = r_;
    take(newton_.improve(tuned::kFirstSteepness, enough_, trial, kBrief), trial);
  }

  // Passes, likewise.
  void pass() {
    if (is_solved()) return;
    Eigen::VectorXd trial = r_;
    take(pass_over_friction(island_, bound_, trial, kMore * enough_), trial);
  }

  void newton(Eigen::VectorXd trial, double steepness) {
    take(newton_.improve(steepness, enough_, trial), trial);
  }

 private:
  void take(double found, const Eigen::VectorXd& r) {
    const double rounding = island_.rounding_of_residual(bound_, r);
    if (rounding > enough_) found = std::max(found, rounding);
    if (!(found < residual_)) return;
    residual_ = found;
    r_ = r;
  }

  static constexpr double kMore = 0.1;  // of what is enough: the last passes gain much
  static constexpr int kBrief = 3;      // rounds

  const FrictionIsland& island_;
  double bound_, enough_;
  IslandNewton newton_;
  double residual_;
  Eigen::VectorXd& r_;
};

// A first guess that is good enough for many contacts gets better all the same: what stands would drift by
// what is left.
double refined(const FrictionIsland& island, double bound, double passed, Eigen::VectorXd& r) {
  if (passed <= kSolvedFriction) return passed;
  Ladder ladder(island, bound, kSolvedFriction, passed, r);
  ladder.newton_briefly();
  return ladder.residual();
}

}  // namespace

// Passes bring contacts near their law soon. Newton's method may end where F is least nearby; then it begins
// elsewhere.
double solve_friction(const FrictionIsland& island, FrictionSolver* friction, Eigen::VectorXd& r,
                      bool roughly) {
  const std::size_t count = island.contacts.size();
  const bool first = r.isZero(0), many = roughly && count > kFewContacts;
  const double bound = island.bound_of_W();
  const double enough = many ? kMostRough : enough_friction(count, first);
  const Eigen::VectorXd guess = r;
  const double passed = pass_over_friction(island, bound, r, many ? tuned::kRoughFriction : kPassedFriction);
  if (many && passed <= enough_friction(count, first)) return refined(island, bound, passed, r);
  if (passed <= enough) return passed;
  Ladder ladder(island, bound, enough, passed, r);
  const Eigen::VectorXd passes = r;
  ladder.newton(passes, tuned::kFirstSteepness);
  Eigen::VectorXd interior;
  for (const Rung& rung : kRungs) {
    if (ladder.is_solved()) break;
    if (rung.from == From::interior && interior.size() == 0)
      IslandInterior(island, bound).solve(enough, interior = passes);
    const Eigen::VectorXd& start = rung.from == From::passes ? passes
                                   : rung.from == From::best ? r
                                                             : interior;
    ladder.newton(rung.share * start, rung.steepness);
  }
  ladder.pass();
  if (friction == nullptr || ladder.residual() <= std::max(enough, hard_friction(count, first)))
    return ladder.residual();
  Eigen::VectorXd trial = guess;
  friction->solve(island.dense(), trial);
  ladder.newton(trial, tuned::kFirstSteepness);
  return ladder.residual();
}

}  // namespace raygauge
