// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_sifting {
namespace {

// Both sets stretched along one direction: the map is linear, so the program is the round one's, but for
// rounding and for a first guess of the normal that is far off. It once took 4000 pivots, a pass over all
// points after each.
class StretchedSets : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seeds, StretchedSets, ::testing::Range(0, 12));

TEST_P(StretchedSets, TakeAFewPassesOverAllPoints) {
  Random random(static_cast<unsigned>(500 + GetParam()));
  const int n = GetParam() % 2 == 0 ? 5 : 10;
  Eigen::MatrixXd a = sphere_points(n, 20000, random);
  Eigen::MatrixXd q = sphere_points(n, 20000, random);
  a.colwise() += 3 * sphere_points(n, 1, random).col(0);
  const Vector w = sphere_points(n, 1, random);
  for (Eigen::MatrixXd* points : {&a, &q}) *points += 1e4 * w * (w.transpose() * *points).eval();

  DistanceSolver solver;
  const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.counters.support_queries, 16) << "two a pass";
  EXPECT_LE(result.counters.pivots, 10 * n) << "as many as for round sets";
  EXPECT_EQ(result.counters.exact_pivots, 0);
}

// Blocks of 8 doubles and of 16 single-precision numbers are filled up with copies of the last point. One of
// those was once taken for a point of its own, beyond the end of the doubles.
TEST(Sifting, DoesNotTakeFillingLanesForPoints) {
  Random random(520);
  DistanceSolver solver;
  for (int N = 17; N <= 48; ++N) {
    for (const int n : {2, 3, 5, 10}) {
      Eigen::MatrixXd a = sphere_points(n, N, random);
      const Eigen::MatrixXd q = sphere_points(n, N, random);
      a.colwise() += 3 * sphere_points(n, 1, random).col(0);
      const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
      if (result.status == DistanceStatus::unreachable) continue;  // few points in many dimensions
      EXPECT_EQ(result.status, DistanceStatus::optimal) << "n = " << n << ", N = " << N;
      EXPECT_EQ(result.counters.refactorisations, 0) << "n = " << n << ", N = " << N;
    }
  }
}

// Half of the sets of 2 n points of the sphere have the origin outside: no multiple of Q may reach A then. A
// vertex of the first phase leaves n points of Q in its plane, up to rounding; once that went to exact
// arithmetic, for half a second at n = 50.
TEST(Sifting, ProvesUnreachableInDoubles) {
  int unreachable = 0;
  for (const int n : {20, 50, 100}) {
    for (const int N : {n + 2, 3 * n / 2, 2 * n}) {
      Random random(static_cast<unsigned>(n + N));
      const Eigen::MatrixXd q = sphere_points(n, N, random);
      Eigen::MatrixXd a = sphere_points(n, N, random);
      a.colwise() += 3 * sphere_points(n, 1, random).col(0);
      const PointSet A(a);
      const PointSet Q(q);
      DistanceSolver solver;
      const DistanceResult& result = solver.solve(A, Q);
      EXPECT_EQ(result.counters.exact_pivots, 0) << "n = " << n << ", N = " << N;
      if (result.status == DistanceStatus::unreachable) {
        ++unreachable;
        EXPECT_LT((result.normal.transpose() * a).maxCoeff(), 0) << "a Farkas direction";
        EXPECT_GT((result.normal.transpose() * q).minCoeff(), 0) << "strictly";
      } else {
        EXPECT_EQ(result.status, DistanceStatus::optimal) << "n = " << n << ", N = " << N;
      }
    }
  }
  EXPECT_GE(unreachable, 6);
}

// Bounds of 1e-12 on a needle, which doubles alone do not close: 0.2 s of exact arithmetic at n = 50, and
// none within any time limit at n = 100.
TEST(Sifting, ProvesTwelveDigitsInManyDimensionsWithoutExactArithmetic) {
  for (const int n : {20, 50, 100}) {
    Random random(static_cast<unsigned>(900 + n));
    Eigen::MatrixXd a = sphere_points(n, 3 * n, random);
    Eigen::MatrixXd q = sphere_points(n, 3 * n, random);
    a.colwise() += 3 * sphere_points(n, 1, random).col(0);
    const Vector w = sphere_points(n, 1, random);
    for (Eigen::MatrixXd* points : {&a, &q}) *points += 1e4 * w * (w.transpose() * *points).eval();
    DistanceOptions options;
    options.tolerance = 1e-12;
    DistanceSolver solver(options);
    const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
    EXPECT_EQ(result.status, DistanceStatus::optimal) << "n = " << n;
    EXPECT_LE(result.upper - result.lower, 1e-12 * result.upper) << "n = " << n;
    EXPECT_EQ(result.counters.exact_pivots, 0) << "n = " << n;
  }
}

// The working sets took points twice until they held as many as the sets, and the solve then gave up with
// points still missing: exact arithmetic went on for 10 s.
TEST(Sifting, FindsThePointsItMissesWhereTheSampleIsHalfOfTheSet) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Random random(700 + seed);
    const PointSet Q(sphere_points(100, 300, random));
    Eigen::MatrixXd a = sphere_points(100, 300, random);
    a.colwise() += 3 * sphere_points(100, 1, random).col(0);
    DistanceSolver solver;
    const DistanceResult& result = solver.solve(PointSet(a), Q);
    EXPECT_EQ(result.status, DistanceStatus::optimal) << "seed " << seed;
    EXPECT_EQ(result.counters.exact_pivots, 0) << "seed " << seed;
  }
}

// Points (t, t², …, t^n): bases of condition 10¹⁸, and Q has the origin outside by less than the rounding of
// its points. Exact arithmetic took 0.8 s at n = 50 and 2 s at n = 100.
TEST(Sifting, DecidesMomentCurvesWithoutExactArithmetic) {
  for (const int n : {20, 50, 100, 130}) {
    Random random(static_cast<unsigned>(n));
    const int N = n > 100 ? 600 : 120;  // more than are evaluated one by one
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto curve = [&] {
      Eigen::MatrixXd points(n, N);
      for (int i = 0; i < N; ++i) {
        const double t = uniform(random);
        double power = 1;
        for (int k = 0; k < n; ++k) points(k, i) = power *= t;
      }
      return points;
    };
    Eigen::MatrixXd a = curve();
    Eigen::MatrixXd q = curve();
    q.colwise() -= q.rowwise().mean().eval();
    a.colwise() += 2 * sphere_points(n, 1, random).col(0);
    for (const double tolerance : {1e-6, 1e-12}) {
      DistanceOptions options;
      options.tolerance = tolerance;
      DistanceSolver solver(options);
      const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
      EXPECT_TRUE(result.status == DistanceStatus::optimal || result.status == DistanceStatus::unreachable)
          << "n = " << n << ": " << to_string(result.status);
      EXPECT_EQ(result.counters.exact_pivots, 0) << "n = " << n << ", tolerance " << tolerance;
    }
  }
}

// A = {λq} and integers with many ties: n weights of the optimum are exactly zero, and with few points Q has
// the origin outside, so that no residual can be paid for. Exact arithmetic took seconds at n = 100.
TEST(Sifting, ProvesWeightsToBeZeroInManyDimensions) {
  for (const int n : {20, 50, 100}) {
    Random random(static_cast<unsigned>(2000 + n));
    Eigen::MatrixXd q = integer_points(n, n + 20, 1 << 20, random);
    q.row(0).setConstant(1 << 18);  // all on a facet: e_1 proves the distance
    Eigen::MatrixXd a = integer_points(n, n + 20, 1 << 20, random);
    a.row(0).setConstant(3 << 18);
    a.col(7) = 3 * q.col(11);
    for (int k = 0; k + 1 < n; ++k) {  // shears, exact: e_1 bounds as before
      q.row(k + 1) += 37 * q.row(k);
      a.row(k + 1) += 37 * a.row(k);
      if (q.cwiseAbs().maxCoeff() > 0x1p45) break;
    }
    DistanceOptions options;
    options.tolerance = 1e-12;
    DistanceSolver solver(options);
    const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
    EXPECT_EQ(result.status, DistanceStatus::optimal) << "n = " << n;
    EXPECT_LE(result.lower, 3) << "n = " << n;
    EXPECT_GE(result.upper, 3) << "n = " << n;
    EXPECT_EQ(result.counters.exact_pivots, 0) << "n = " << n;
  }
}

}  // namespace
}  // namespace raygauge::test_sifting
