// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// Of so many contacts a matrix is soon factorized.
inline constexpr std::size_t kFewContacts = 24;

/// The residual up to which it tells which bodies meet, where passes go no further than that.
inline constexpr double kMostRough = 1e-2;

/// The residual that passes aim at.
inline constexpr double kPassedFriction = 1e-10;

/// The residual from which on a friction problem is solved.
inline constexpr double kSolvedFriction = 1e-9;

/// The residual from which on a problem of so many contacts is left as it is. Of many, Gauss and Seidel's
/// passes arrive at a little more than 1e-9 here and there, where Newton's method takes as long again for
/// what nobody sees; but bodies that begin to stand (`first`: nothing is known of a step before) are to
/// stand.
inline constexpr double enough_friction(std::size_t contacts, bool first) {
  constexpr double kEnoughOfMany = 9e-9;
  constexpr std::size_t kMany = 100;
  return contacts > kMany && !first ? kEnoughOfMany : kSolvedFriction;
}

/// Passes over the contacts of an island, each solved by itself while the others stay (Gauss and Seidel's
/// method), extrapolated by Anderson's method (1965) from the last passes. From a first guess r until
/// island_residual() is `enough`, or no longer falls. Returns it; `bound` is bound_of_W().
double pass_over_friction(const FrictionIsland& island, double bound, Eigen::VectorXd& r,
                          double enough = kPassedFriction);

}  // namespace raygauge
