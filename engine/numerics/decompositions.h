// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What the engine asks of Eigen's decompositions of matrices of any size. Compiled once: a decomposition
// costs as much to compile as a whole file that uses it.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace raygauge {

/// M⁻¹ by an LU factorisation with partial pivoting; entries that are not finite where M is singular.
Eigen::MatrixXd lu_inverse(const Eigen::MatrixXd& M);

/// Does a factorisation with full pivoting find a pivot in every row?
bool is_invertible(const Eigen::MatrixXd& M);

double lu_determinant(const Eigen::MatrixXd& M);

/// L, lower triangular, with M = L Lᵀ; empty if M (symmetric) is not positive definite.
std::optional<Eigen::MatrixXd> cholesky_factor(const Eigen::MatrixXd& M);

/// The least eigenvalue of M (symmetric).
double least_eigenvalue(const Eigen::MatrixXd& M);

/// R, upper triangular, of M = W R by Householder reflections, M with at least as many rows as columns.
Eigen::MatrixXd qr_triangle(const Eigen::MatrixXd& M);

/// M = U diag(σ) Vᵀ, σ falling.
struct RightSingular {
  Eigen::VectorXd values;   ///< σ
  Eigen::MatrixXd vectors;  ///< V
};

RightSingular right_singular(const Eigen::MatrixXd& M);

}  // namespace raygauge
