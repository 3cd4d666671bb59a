// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/gauge_bound.h"

#include <cstdint>
#include <limits>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/splitmix64.h"

namespace raygauge {
namespace {

constexpr double kFirstNormalError = 0.25;  // of the first normal, relative

}  // namespace

// Multiples of the golden ratio would not do, they are related: φ + 2φ = 3φ.
double generic_coordinate(int k) {
  const double fraction = static_cast<double>(splitmix64(static_cast<std::uint64_t>(k))) * 0x1p-64;
  return (k % 2 == 0 ? 0.5 : -0.5) * (1 + fraction);
}

double GaugeBound::compute(const ColumnPool& Q, int n, const Kernels& kernels, const Stopwatch& stopwatch) {
  n_ = n;
  kernels_ = &kernels;
  point_.reserve(2 * static_cast<std::size_t>(n));
  const double ahead = gauge_of_target(Q, 1.0, stopwatch);
  if (!(ahead < kInfinity)) return kInfinity;
  const double radius = program_.basis().cone_radius();
  if (!(radius > 0)) return kInfinity;
  const double behind = gauge_of_target(Q, -1.0, stopwatch);
  constexpr double kRoundedUp = 1 + 8 * std::numeric_limits<double>::epsilon();
  return (2 * ahead + behind) / radius * kRoundedUp;
}

double GaugeBound::gauge_of_target(const ColumnPool& Q, double sign, const Stopwatch& stopwatch) {
  double* target = point_.data();
  double* guess = target + n_;
  for (int k = 0; k < n_; ++k) {
    target[k] = sign * generic_coordinate(k);
    guess[k] = -target[k];
  }
  target_.clear(n_);
  target_.add(target);
  program_.begin(n_, std::numeric_limits<double>::min(), 0, *kernels_);
  program_.start(target_, Q, {guess, kFirstNormalError});
  PrimalSimplex::End end = program_.solve(target_, Q, stopwatch);
  while (end == PrimalSimplex::End::bounded) {
    program_.raise_bounds();
    end = program_.solve(target_, Q, stopwatch);
  }
  return end == PrimalSimplex::End::solved ? program_.proven_upper() : kInfinity;
}

}  // namespace raygauge
