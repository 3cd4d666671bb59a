// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <Eigen/Dense>

#include <raygauge/raygauge.h>

// The caller's copies of Eigen's products and factorisations, compiled with its own flags, and raygauge's, in
// turn.
int main() {
  for (int n = 2; n <= 40; ++n) {
    const Eigen::MatrixXd M = Eigen::MatrixXd::Random(3 * n, n) + 2 * Eigen::MatrixXd::Identity(3 * n, n);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1, 1);
    const Eigen::MatrixXd normal_matrix = M.transpose() * M;
    if (!(normal_matrix.ldlt().solve(M.transpose() * (M * x)) - x).isZero(1e-9)) return 1;

    const Eigen::MatrixXd L = 0.1 / n * Eigen::MatrixXd::Random(n, n) + Eigen::MatrixXd::Identity(n, n);
    const raygauge::Ellipsoid Q(Eigen::VectorXd::Zero(n), L);
    const raygauge::PointSet A(2 * L.col(0));  // one point on the boundary of 2 Q
    raygauge::DistanceSolver solver;
    const raygauge::DistanceResult result = solver.solve(A, Q, raygauge::Effects::witness);
    if (!(result.lower <= 2 + 1e-6 && result.upper >= 2 - 1e-6)) return 1;
    if (result.normal.size() != n || !(result.contact_point - 2 * L.col(0)).isZero(1e-4)) return 1;
  }
}
