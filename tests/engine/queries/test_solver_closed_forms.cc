// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_closed_forms {
namespace {

// Coordinates are multiples of 1/4, so that the closed forms below are computed without rounding.
using ClosedForms = BothMethods;
RAYGAUGE_BOTH_METHODS(ClosedForms);

Vector quarters(int n, Random& random) {
  Vector p = 0.25 * integer_points(n, 1, 40, random);
  p[0] += 11;  // never the origin
  return p;
}

// Σ (|c_i| - t)₊ = r, solved for t; -1 where the origin is inside.
double cross_polytope_to_cube(const Vector& c, double r) {
  Vector sorted = c.cwiseAbs();
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double sum = 0;
  for (Eigen::Index k = 0; k < sorted.size(); ++k) {
    sum += sorted[k];
    const double t = (sum - r) / static_cast<double>(k + 1);
    if (k + 1 == sorted.size() || t >= sorted[k + 1]) return t;
  }
  return -1;
}

TEST_P(ClosedForms, OfAPointAgainstTheCubeIsItsMaximumNorm) {
  Random random(61);
  for (const int n : {1, 2, 3, 5, 8, 11}) {
    const Vector p = quarters(n, random);
    expect_distance(p.lpNorm<Eigen::Infinity>(), p, cube_vertices(n));
  }
}

TEST_P(ClosedForms, OfAPointAgainstTheCrossPolytopeIsItsSumNorm) {
  Random random(62);
  for (const int n : {1, 2, 3, 5, 8, 20, 50}) {
    const Vector p = quarters(n, random);
    expect_distance(p.lpNorm<1>(), p, cross_polytope_vertices(n));
  }
}

TEST_P(ClosedForms, OfAPointAgainstTheSimplexCountsItsMostNegativeCoordinate) {
  Random random(63);
  for (const int n : {1, 2, 3, 5, 8, 20, 50}) {
    for (const double sign : {1.0, -1.0}) {
      const Vector p = sign * quarters(n, random);
      expect_distance(p.sum() + (n + 1) * std::max(0.0, -p.minCoeff()), p, simplex_vertices(n));
    }
  }
}

TEST_P(ClosedForms, OfACrossPolytopeAgainstTheCube) {
  Random random(65);
  for (const int n : {1, 2, 4, 8}) {  // powers of two: the quotient below is exact or all but so
    const Vector c = quarters(n, random);
    const double r = 1.5;
    const double t = cross_polytope_to_cube(c, r);
    const Eigen::MatrixXd A = (r * cross_polytope_vertices(n)).colwise() + c;
    const DistanceResult result = solve(A, cube_vertices(n), 1e-12);
    EXPECT_EQ(result.status, DistanceStatus::optimal);
    EXPECT_LE(result.lower, t * (1 + 1e-15));
    EXPECT_GE(result.upper, t * (1 - 1e-15));
  }
}

TEST_P(ClosedForms, OfTheUnitVectorsEveryOneOfWhichIsOptimal) {
  for (const int n : {1, 2, 4, 8}) {
    expect_distance(3, 3 * Eigen::MatrixXd::Identity(n, n), cross_polytope_vertices(n));
    expect_distance(3.0 / n, 3 * Eigen::MatrixXd::Identity(n, n), cube_vertices(n));
  }
}

TEST_P(ClosedForms, OfALatticeIgnoreItsCollinearPoints) {
  for (const int n : {1, 2, 3, 4}) {
    const Eigen::MatrixXd lattice = lattice_points(n, 5).array() + 1;  // the box [1, 6]^n
    expect_distance(n, lattice, cross_polytope_vertices(n));
    expect_distance(1, lattice, cube_vertices(n));
    const Eigen::MatrixXd gauge =
        lattice_points(n, 4).array() - 2;  // the cube [-2, 2]^n with its inner points
    expect_distance(0.5, lattice, gauge);
  }
}

TEST_P(ClosedForms, OfContactIsOneWithinTheBounds) {
  Eigen::MatrixXd touching = cube_vertices(3);
  touching.row(1).array() += 2;
  expect_distance(1, touching, cube_vertices(3));
}

}  // namespace
}  // namespace raygauge::test_solver_closed_forms
