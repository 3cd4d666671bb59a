// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/linear_algebra.h"

#include <Eigen/LU>
#include <Eigen/QR>

namespace raygauge {
namespace {

using Decomposition = Eigen::FullPivLU<Eigen::MatrixXd>;

}  // namespace

Vector solution(const Eigen::MatrixXd& M, const Vector& b) { return Decomposition(M).solve(b); }

double determinant(const Eigen::MatrixXd& M) { return Decomposition(M).determinant(); }

Eigen::Index rank(const Eigen::MatrixXd& M) { return M.isZero(0) ? 0 : Decomposition(M).rank(); }

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& M) { return M.householderQr().householderQ(); }

}  // namespace raygauge
