// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_invariance {
namespace {

using Matrix = Eigen::MatrixXd;

struct Pair {
  Matrix A;
  Matrix Q;
};

Pair separated_spheres(int n, int N, Random& random) {
  Pair pair{sphere_points(n, N, random), sphere_points(n, N, random)};
  pair.A.colwise() += 4 * sphere_points(n, 1, random).col(0);
  return pair;
}

Matrix shuffled(const Matrix& points, Random& random) {
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  return points(Eigen::all, order);
}

// Integer, determinant 1: a product of shears.
Matrix unimodular(int n, Random& random) {
  Matrix map = Matrix::Identity(n, n);
  for (int step = 0; step < 3 * n; ++step) {
    const auto i = static_cast<Eigen::Index>(random() % static_cast<unsigned>(n));
    const auto j = static_cast<Eigen::Index>(random() % static_cast<unsigned>(n));
    if (i != j) map.row(i) += (step % 2 == 0 ? 1 : -1) * map.row(j);
  }
  return map;
}

class Invariance : public BothMethods {
 protected:
  // Both answers certified, and there is a number that both intervals contain.
  static void expect_same(const Pair& one, const Pair& other) {
    const DistanceResult first = solve(one.A, one.Q, 1e-10);
    const DistanceResult second = solve(other.A, other.Q, 1e-10);
    EXPECT_EQ(first.status, DistanceStatus::optimal);
    EXPECT_EQ(second.status, DistanceStatus::optimal);
    EXPECT_LE(first.lower, second.upper);
    EXPECT_LE(second.lower, first.upper);
  }

  Random random_{71};
  const std::vector<int> dimensions_ = {1, 2, 3, 4, 7, 10};
};
RAYGAUGE_BOTH_METHODS(Invariance);

TEST_P(Invariance, ScalingBothSetsByAPowerOfTwoKeepsTheDistance) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 12 * n, random_);
    for (const int exponent : {-500, -40, -3, 1, 5, 60, 500}) {
      const double factor = std::ldexp(1.0, exponent);
      expect_same(pair, {factor * pair.A, factor * pair.Q});
    }
  }
}

TEST_P(Invariance, FarScalesOfTheSameSetsGiveTheSameBits) {
  // Beyond 2^±4 both sets are brought to magnitude one, and everything after that is the same.
  const Pair pair = separated_spheres(5, 60, random_);
  const DistanceResult low = solve(0x1p-300 * pair.A, 0x1p-300 * pair.Q);
  const DistanceResult high = solve(0x1p300 * pair.A, 0x1p300 * pair.Q);
  EXPECT_EQ(low.distance, high.distance);
  EXPECT_EQ(low.lower, high.lower);
  EXPECT_EQ(low.upper, high.upper);
}

TEST_P(Invariance, ScalingAScalesTheDistanceAndScalingQDividesIt) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 12 * n, random_);
    const DistanceResult plain = solve(pair.A, pair.Q, 1e-10);
    for (const int exponent : {-400, -27, 2, 27, 400}) {
      const double factor = std::ldexp(1.0, exponent);
      const DistanceResult grown_A = solve(factor * pair.A, pair.Q, 1e-10);
      const DistanceResult grown_Q = solve(pair.A, factor * pair.Q, 1e-10);
      EXPECT_EQ(grown_A.status, DistanceStatus::optimal) << "factor 2^" << exponent;
      EXPECT_LE(grown_A.lower, factor * plain.upper);
      EXPECT_GE(grown_A.upper, factor * plain.lower);
      EXPECT_EQ(grown_Q.status, DistanceStatus::optimal) << "factor 2^" << exponent;
      EXPECT_LE(grown_Q.lower, plain.upper / factor);
      EXPECT_GE(grown_Q.upper, plain.lower / factor);
    }
  }
}

TEST_P(Invariance, TheOrderOfThePointsDoesNotMatter) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 50 * n, random_);
    expect_same(pair, {shuffled(pair.A, random_), shuffled(pair.Q, random_)});
  }
}

TEST_P(Invariance, RepeatedPointsDoNotMatter) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 12 * n, random_);
    expect_same(pair,
                {shuffled(pair.A.replicate(1, 50), random_), shuffled(pair.Q.replicate(1, 50), random_)});
  }
}

TEST_P(Invariance, InteriorPointsDoNotMatter) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 12 * n, random_);
    Matrix A(n, 24 * n);
    Matrix Q(n, 24 * n);
    // Midpoints towards a point of the set itself: inside, and no vertex.
    A << pair.A, 0.5 * (pair.A.colwise() + pair.A.rowwise().mean());
    Q << pair.Q, 0.5 * pair.Q;
    expect_same(pair, {shuffled(A, random_), shuffled(Q, random_)});
  }
}

TEST_P(Invariance, UnimodularMapsKeepTheDistance) {
  for (const int n : {2, 3, 4, 7}) {
    for (int trial = 0; trial < 5; ++trial) {
      Pair pair{integer_points(n, 40, 50, random_), integer_points(n, 40, 20, random_)};
      pair.A.row(0).array() += 120;
      const Matrix map = unimodular(n, random_);
      expect_same(pair, {map * pair.A, map * pair.Q});  // integers below 2^53: mapped without rounding
    }
  }
}

TEST_P(Invariance, MorePointsInEitherSetCannotRaiseTheDistance) {
  for (const int n : dimensions_) {
    const Pair pair = separated_spheres(n, 40 * n, random_);
    double upper_before = std::numeric_limits<double>::infinity();
    for (const int N : {20 * n, 30 * n, 40 * n}) {
      const DistanceResult more_A = solve(pair.A.leftCols(N), pair.Q.leftCols(20 * n), 1e-10);
      EXPECT_LE(more_A.lower, upper_before);
      upper_before = more_A.upper;
    }
    for (const int N : {30 * n, 40 * n}) {
      const DistanceResult more_Q = solve(pair.A, pair.Q.leftCols(N), 1e-10);
      EXPECT_LE(more_Q.lower, upper_before);
      upper_before = more_Q.upper;
    }
  }
}

TEST_P(Invariance, ASolverRemembersNothingOfEarlierSolves) {
  DistanceSolver used(options(1e-6));
  Pair other = separated_spheres(9, 300, random_);
  used.solve(PointSet(other.A), PointSet(other.Q), Effects::witness);
  used.solve(PointSet(cube_vertices(4)), PointSet(cross_polytope_vertices(4)));
  const Pair pair = separated_spheres(5, 100, random_);
  const PointSet A(pair.A);
  const PointSet Q(pair.Q);
  const DistanceResult fresh = DistanceSolver(options(1e-6)).solve(A, Q);
  const DistanceResult& again = used.solve(A, Q);
  EXPECT_EQ(again.distance, fresh.distance);
  EXPECT_EQ(again.lower, fresh.lower);
  EXPECT_EQ(again.upper, fresh.upper);
  EXPECT_EQ(again.normal, fresh.normal);
  EXPECT_EQ(again.contact_point.size(), 0);
  EXPECT_EQ(again.counters, fresh.counters);
}

}  // namespace
}  // namespace raygauge::test_solver_invariance
