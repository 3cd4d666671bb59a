// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"

#include "analysis/data/instances.h"

namespace raygauge {

struct ProfileStep {
  double tau = 0;
  double rho = 0;
};

/// ρ(τ) of one method: the fraction of all instances that it solved within τ times the time of the method
/// that was fastest on the instance.
struct ProfileCurve {
  std::string method;
  std::vector<double> ratios;  ///< time / fastest time of the instances that it solved, sorted
  std::size_t instances = 0;   ///< all of them, whether anyone solved them or not
  double rho(double tau) const;

  /// The corners of the step function from τ = 1 to `last`, of the ratios between at most about `most`.
  std::vector<ProfileStep> steps(double last, std::size_t most) const;
};

/// Where a picture of the curves ends: a little beyond the largest ratio, and at least 2.
double profile_end(const std::vector<ProfileCurve>& curves);

/// Performance profiles of Dolan and Moré (2002, "Benchmarking optimization software with performance
/// profiles") over instances (cell of the grid, seed, repetition). A solve that stopped at a limit, that
/// disagrees with the others or that is missing counts as unsolved: its ratio is infinite. One curve a
/// method, in order of first appearance. Throws EmptySetError without records.
std::vector<ProfileCurve> performance_profiles(const std::vector<Record>& records);

/// The same over cells of instances_by_cell(), methods in the order of `methods`.
std::vector<ProfileCurve> performance_profiles(const std::vector<const std::vector<MethodInstances>*>& cells,
                                               const std::vector<std::string>& methods);

}  // namespace raygauge
