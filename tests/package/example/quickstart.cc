// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <raygauge/raygauge.h>

#include <iostream>

int main() {
  Eigen::MatrixXd a(2, 3), q(2, 4);  // a triangle and a square in the plane, one point a column
  a << 2, 4, 4, 0, -1, 1;
  q << 1, -1, 0, 0, 0, 0, 1, -1;
  raygauge::DistanceSolver solver;  // one a thread: it keeps its workspace
  const auto& r = solver.solve(raygauge::PointSet(a), raygauge::PointSet(q));
  std::cout << "distance " << r.distance << ", certified to lie in [" << r.lower << ", " << r.upper << "]\n";
}
