// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace raygauge {
namespace {

using Eigen::MatrixXd;

}  // namespace

MatrixXd lu_inverse(const MatrixXd& M) { return M.partialPivLu().inverse(); }

bool is_invertible(const MatrixXd& M) { return Eigen::FullPivLU<MatrixXd>(M).isInvertible(); }

double lu_determinant(const MatrixXd& M) { return M.determinant(); }

std::optional<MatrixXd> cholesky_factor(const MatrixXd& M) {
  const Eigen::LLT<MatrixXd> factors(M);
  if (factors.info() != Eigen::Success) return {};
  return MatrixXd(factors.matrixL());
}

double least_eigenvalue(const MatrixXd& M) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(M, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

MatrixXd qr_triangle(const MatrixXd& M) {
  const Eigen::HouseholderQR<MatrixXd> qr(M);
  return qr.matrixQR().topRows(qr.cols()).triangularView<Eigen::Upper>();
}

RightSingular right_singular(const MatrixXd& M) {
  const Eigen::JacobiSVD<MatrixXd> svd(M, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

}  // namespace raygauge
