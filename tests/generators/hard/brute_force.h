// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/gmp.hpp>
#include <optional>

namespace raygauge {

using Rational = boost::multiprecision::mpq_rational;

/// d = min {Σβ : Σα_i a_i = Σβ_j q_j, Σα = 1, α, β >= 0} of the columns of A and Q, in rational arithmetic
/// and with no algorithm to trust: a minimum, where there is one, is reached by linearly independent columns,
/// so every set of at most n+1 columns is tried. Empty where nothing is feasible (d = +infinity). For small
/// sets only.
std::optional<Rational> brute_force_distance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q);

/// Whether `rounded` is a double nearest to `exact`.
bool is_nearest_double(const Rational& exact, double rounded);

}  // namespace raygauge
