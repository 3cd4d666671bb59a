// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What tests ask of Eigen's decompositions. Compiled once: a decomposition costs as much to compile as the
// tests of a whole file.
#pragma once

#include <Eigen/Core>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// x with M x = b, where there is one.
Vector solution(const Eigen::MatrixXd& M, const Vector& b);

double determinant(const Eigen::MatrixXd& M);

/// 0 of a matrix of zeros.
Eigen::Index rank(const Eigen::MatrixXd& M);

/// R of M = R T, R orthogonal and T upper triangular.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& M);

}  // namespace raygauge
