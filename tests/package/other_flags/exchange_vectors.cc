// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <raygauge/raygauge.h>

#include <utility>

// Matrices and vectors that the library allocated are freed here, and the other way round.
int main() {
  for (int n = 1; n <= 9; ++n) {
    const Eigen::MatrixXd corners = Eigen::MatrixXd::Identity(n, n);
    const raygauge::PointSet simplex(corners);
    if (simplex.points() != corners) return 1;
    if (simplex.support_mapping(corners.col(0)) != corners.col(0)) return 1;

    raygauge::DistanceSolver solver;
    raygauge::DistanceResult result = solver.solve(simplex, simplex, raygauge::Effects::witness);
    const raygauge::DistanceResult kept = std::move(result);
    if (kept.normal.size() != n || kept.contact_point.size() != n) return 1;
    result = solver.solve(simplex, simplex);

    Eigen::MatrixXd G(2 * n, n);
    G << corners, -corners;
    const raygauge::HPolytope box(G, Eigen::VectorXd::Ones(2 * n));
    if (box.support_function(corners.col(0)) < 1) return 1;
  }
}
