// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/growth_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/queries/growth_body.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_growth_distance {
namespace {

DistanceOptions newton(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

TEST(GrowthDistance, OfBallsIsTheDistanceOfTheirCentersOverTheSumOfTheirRadii) {
  Random random(91);
  GrowthDistanceSolver solver(newton(1e-12));
  for (const int n : {1, 2, 3, 6}) {
    for (const double size : {0.5, 2.0, 8.0}) {
      const Vector c = size * sphere_points(n, 1, random);
      const DistanceResult& result = solver.solve(Ball(c, 1.5), Ball(Vector::Zero(n), 0.5));
      EXPECT_EQ(result.status, DistanceStatus::optimal);
      EXPECT_NEAR(result.distance, size / 2, 1e-12 * size);
    }
  }
}

TEST(GrowthDistance, OfBoxesIsTheLargestRatioAlongAnAxis) {
  Random random(92);
  GrowthDistanceSolver solver(newton(1e-9));
  for (const int n : {2, 3, 5}) {
    const Vector c = 3 * gaussian_points(n, 1, random), a = gaussian_points(n, 1, random).cwiseAbs(),
                 q = gaussian_points(n, 1, random).cwiseAbs();
    const double truth = c.cwiseAbs().cwiseQuotient(a + q).maxCoeff();
    const DistanceResult& result = solver.solve(Box(c - a, c + a), Box(-q, q));
    EXPECT_NEAR(result.distance, truth, 1e-9 * truth);
  }
}

TEST(GrowthDistance, RefusesSetsOfDifferentDimension) {
  GrowthDistanceSolver solver;
  EXPECT_THROW(solver.solve(Ball(Vector::Zero(2), 1), Ball(Vector::Zero(3), 1)), DimensionMismatchError);
  EXPECT_THROW(solver.separation(Ball(Vector::Zero(2), 1), Ball(Vector::Zero(3), 1)), DimensionMismatchError);
}

TEST(SeparationTest, AgreesWithTheDistanceOfCentersOfBalls) {
  Random random(93);
  GrowthDistanceSolver solver(newton(1e-9));
  for (int i = 0; i < 100; ++i) {
    const Vector c = gaussian_points(3, 1, random);
    const SeparationResult& result = solver.separation(Ball(Vector::Zero(3), 0.7), Ball(c, 0.8));
    EXPECT_EQ(result.outcome, c.norm() > 1.5 ? Separation::separated : Separation::intersecting) << c.norm();
  }
}

TEST(SeparationTest, ProvesItselfByAPlane) {
  Random random(94);
  GrowthDistanceSolver solver(newton(1e-9));
  int separated = 0;
  for (int i = 0; i < 100; ++i) {
    const Ellipsoid A1(Vector::Zero(4), gaussian_points(4, 4, random));
    const Ellipsoid A2(3 * gaussian_points(4, 1, random), gaussian_points(4, 4, random));
    const SeparationResult& result = solver.separation(A1, A2);
    ASSERT_NE(result.outcome, Separation::undecided);
    if (result.outcome != Separation::separated) {
      EXPECT_EQ(result.normal.size(), 0);
      continue;
    }
    ++separated;
    EXPECT_LT(A2.support_function(result.normal), -A1.support_function(-result.normal));
  }
  EXPECT_GT(separated, 10);
}

// The difference of such a Q has no ball about the origin, however large those of A are: residuals have no
// price.
TEST(GrowthDistance, HasNoBallAboutAnOriginOutsideQ) {
  const Ball A(Eigen::Vector3d(3, 0, 0), 1), Q(Eigen::Vector3d(5, 0, 0), 1);
  const Vector c_A = A.center(), zero = Vector::Zero(3), c_Q = Q.center();
  EXPECT_EQ(GrowthBody(A, {c_A.data()}, Q, {zero.data()}, false).inner_radius_unchecked(zero.data()), 0);
  EXPECT_NEAR(GrowthBody(A, {c_A.data()}, Q, {c_Q.data()}, true).inner_radius_unchecked(zero.data()), 2,
              1e-12);
}

TEST(SeparationTest, StopsAtTheFirstCertificate) {
  Random random(95);
  GrowthDistanceSolver solver(newton(1e-9));
  std::int64_t test = 0, distance = 0;
  for (int i = 0; i < 50; ++i) {
    const Ellipsoid Q(Vector::Zero(3), gaussian_points(3, 3, random));
    const Ellipsoid A(6 * sphere_points(3, 1, random), gaussian_points(3, 3, random));
    const std::int64_t whole = solver.solve(A, Q).counters.support_queries;
    const SeparationResult& result = solver.separation(Q, A);
    EXPECT_LE(result.counters.support_queries, whole);
    test += result.counters.support_queries;
    distance += whole;
  }
  EXPECT_LT(test, 0.6 * static_cast<double>(distance));
}

TEST(SeparationTest, OfPolytopesAgreesWithTheirGrowthDistance) {
  Random random(96);
  GrowthDistanceSolver solver(newton(1e-9));
  for (int i = 0; i < 30; ++i) {
    Eigen::MatrixXd a = gaussian_points(3, 20, random);
    a.row(0).array() += 3;
    const PointSet A1(gaussian_points(3, 20, random)), A2(a);
    const SeparationResult test = solver.separation(A1, A2);
    ASSERT_NE(test.outcome, Separation::undecided);
    if (test.outcome == Separation::separated) {
      EXPECT_LT(A2.support_function(test.normal), -A1.support_function(-test.normal));
    } else {
      EXPECT_LT(test.upper, 1);
    }
  }
}

TEST(SeparationTest, OfTouchingBallsDecidesNothingFalsely) {
  GrowthDistanceSolver solver(newton(1e-12));
  const SeparationResult& result =
      solver.separation(Ball(Vector::Zero(3), 1), Ball(2 * Vector::Unit(3, 1), 1));
  EXPECT_NE(result.outcome, Separation::separated);
  EXPECT_LE(result.lower, 1);
  EXPECT_GE(result.upper, 1);
}

// σ to 20 digits by decimal arithmetic, of two needles 1e6 : 1 in these poses. The way between the centres,
// rounded to doubles, gave bounds 4e-14 beyond it.
TEST(GrowthDistance, OfNeedlesDoesNotRoundTheWayBetweenTheCenters) {
  const Eigen::Vector3d half(1, 1e-6, 2e-6);
  const Ellipsoid needle(Vector::Zero(3), half.asDiagonal().toDenseMatrix());
  Eigen::Matrix3d R1, R2;
  R1 << -0.64310266043482023, 0.13414431097531804, -0.75393916994318144, -0.7636111890835775,
      -0.038290442017409276, 0.64453998631308851, 0.057592708288646932, 0.99022176601156797,
      0.12705878194328102;
  R2 << -0.15834242266335785, -0.69256701085821759, 0.70376033751271572, -0.97383250852726455,
      0.22722232620204097, 0.004501089960044391, -0.16302736739760454, -0.68463198139310333,
      -0.71042320312132223;
  const Pose one(R1, Eigen::Vector3d(-0.64983883220467897, 1.0267450034617218, -0.5140644128784867));
  const Pose two(R2, Eigen::Vector3d(0.82264061274124256, -1.1143191491056372, -1.5214157960947112));
  constexpr double kExact = 636.49820563725258863;
  for (const int iterations : {0, 100000}) {
    DistanceOptions options = newton(1e-12);
    options.max_iterations = iterations;
    GrowthDistanceSolver solver(options);
    const DistanceResult& r = solver.solve_about_centers({needle, two}, {needle, one});
    EXPECT_LE(r.lower, kExact) << iterations;
    EXPECT_GE(r.upper, kExact) << iterations;
    EXPECT_LE(r.upper - r.lower, 1e-6 * kExact) << iterations;
  }
}

// R c + t has no doubles of its own: the general methods took it as rounded and fixed-size code as it is, so
// that their intervals lay apart by up to 1e-11 of the distance for needles away from the origin of their
// coordinates.
TEST(GrowthDistance, OfNeedlesIsAboutTheirCentersAsPosed) {
  Random random(98);
  const Vector center{{7, -3, 5}}, half{{1, 1e-6, 2e-6}};
  const Ellipsoid ellipsoid(center, half.asDiagonal().toDenseMatrix());
  const PointSet points((half.asDiagonal() * sphere_points(3, 30, random)).colwise() + center);
  const auto pose = [&random] {
    const Eigen::Vector4d q = gaussian_points(4, 1, random);
    return Pose(Eigen::Quaterniond(q), 9 * gaussian_points(3, 1, random));
  };
  DistanceOptions general = newton(1e-12);
  general.max_iterations = 100000;
  GrowthDistanceSolver fixed_size(newton(1e-12)), by_general(general);
  for (int i = 0; i < 200; ++i) {
    const Pose one = pose(), two = pose();
    for (const ConvexSet* other :
         {static_cast<const ConvexSet*>(&points), static_cast<const ConvexSet*>(&ellipsoid)}) {
      const DistanceResult& a = fixed_size.solve_about_centers({ellipsoid, one}, {*other, two});
      const DistanceResult& b = by_general.solve_about_centers({ellipsoid, one}, {*other, two});
      EXPECT_LE(a.lower, b.upper) << "pair " << i;
      EXPECT_LE(b.lower, a.upper) << "pair " << i;
    }
  }
}

TEST(Gradient, OfADistanceMatchesFiniteDifferences) {
  Random random(97);
  constexpr double kStep = 1e-5;
  DistanceSolver solver(newton(1e-12));
  const Eigen::MatrixXd L = 0.3 * gaussian_points(3, 3, random) + Eigen::MatrixXd::Identity(3, 3);
  for (int i = 0; i < 20; ++i) {
    const Vector c = 5 * sphere_points(3, 1, random);
    const auto solve = [&](const Vector& move_A, const Vector& move_Q) -> auto& {
      return solver.solve(Ball(c + move_A, 1), Ellipsoid(move_Q, L));
    };
    const Vector zero = Vector::Zero(3);
    const DistanceResult at_rest = solve(zero, zero);
    const Vector moving_A = gradient_moving_A(at_rest), moving_Q = gradient_moving_Q(at_rest);
    for (int k = 0; k < 3; ++k) {
      const Vector move = kStep * Vector::Unit(3, k);
      const double ahead_A = solve(move, zero).distance, behind_A = solve(-move, zero).distance;
      EXPECT_NEAR(moving_A[k], (ahead_A - behind_A) / (2 * kStep), 1e-6);
      const double ahead_Q = solve(zero, move).distance, behind_Q = solve(zero, -move).distance;
      EXPECT_NEAR(moving_Q[k], (ahead_Q - behind_Q) / (2 * kStep), 1e-6);
    }
  }
}

TEST(Gradient, RefusesADistanceOfZero) {
  const DistanceResult result = DistanceSolver().solve(Ball(Vector::Zero(2), 1), Ball(Vector::Zero(2), 1));
  EXPECT_THROW(gradient_moving_A(result), InvalidParameterError);
  EXPECT_THROW(gradient_moving_Q(result), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_growth_distance
