// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/point_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <string>

#include "raygauge/exceptions.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_point_set {
namespace {

constexpr double kRoundoff = std::numeric_limits<double>::epsilon();

// γ_n Σ|u_k| max_i|p_ik| with room to spare for the reference's own rounding.
double dot_tolerance(const Eigen::MatrixXd& points, const Vector& u) {
  return kRoundoff * static_cast<double>(u.size() + 1) *
         (points.cwiseAbs().rowwise().maxCoeff().cwiseProduct(u.cwiseAbs())).sum();
}

Eigen::Index first_maximiser(const Eigen::MatrixXd& points, const Vector& u) {
  Eigen::Index best = 0;
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    if (points.col(i).dot(u) > points.col(best).dot(u)) best = i;
  }
  return best;
}

Random random_stream() { return Random(*rc::gen::arbitrary<std::uint64_t>()); }

TEST(PointSet, AgreesWithBruteForceForEveryDimensionAndEveryFillOfTheLastBlock) {
  Random random(1);
  for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 50}) {
    for (int N = 1; N <= 100; ++N) {
      const Eigen::MatrixXd points = integer_points(n, N, 3, random);
      const Vector u = integer_points(n, 1, 3, random);
      const PointSet S(points);
      const Eigen::Index best = first_maximiser(points, u);
      ASSERT_EQ(S.support_function(u), points.col(best).dot(u)) << "n = " << n << ", N = " << N;
      ASSERT_EQ(S.support_mapping(u), points.col(best)) << "n = " << n << ", N = " << N;
    }
  }
}

TEST(PointSet, StaysWithinRoundingOfBruteForceOnRealCoordinates) {
  Random random(2);
  for (const int n : {1, 2, 3, 5, 8, 10, 13, 20, 50}) {
    for (const int N : {1, 7, 8, 9, 33, 64, 500}) {
      const Eigen::MatrixXd points = gaussian_points(n, N, random);
      const Vector u = gaussian_points(n, 1, random);
      const PointSet S(points);
      const double truth = (points.transpose() * u).maxCoeff();
      EXPECT_NEAR(S.support_function(u), truth, dot_tolerance(points, u));
      EXPECT_NEAR(S.support_mapping(u).dot(u), truth, dot_tolerance(points, u));
    }
  }
}

TEST(PointSet, GivesTheFirstOfSeveralMaximisers) {
  // All 64 vertices with x_1 = 1 maximise e_1·x; the first of them is vertex 1.
  const PointSet cube(cube_vertices(7));
  EXPECT_EQ(cube.support_mapping(Vector::Unit(7, 0)), cube.point(1));
  EXPECT_EQ(cube.support_mapping(Vector::Zero(7)), cube.point(0));
  EXPECT_EQ(cube.support_function(Vector::Zero(7)), 0.0);
}

TEST(PointSet, RoundTripsItsPoints) {
  Random random(3);
  for (const int N : {1, 8, 9, 23}) {
    const Eigen::MatrixXd points = gaussian_points(4, N, random);
    const PointSet S(points);
    EXPECT_EQ(S.dimension(), 4);
    EXPECT_EQ(S.size(), N);
    EXPECT_EQ(S.block_count(), (N + 7) / 8);
    EXPECT_EQ(S.points(), points);
    for (int i = 0; i < N; ++i) EXPECT_EQ(S.point(i), points.col(i));
  }
}

TEST(PointSet, FillsTheLastBlockWithItsLastPoint) {
  Random random(4);
  const Eigen::MatrixXd points = gaussian_points(3, 11, random);
  const PointSet S(points);
  for (int k = 0; k < 3; ++k) {
    for (int lane = 3; lane < PointSet::kLanes; ++lane) {
      EXPECT_EQ(S.data()[(3 + k) * PointSet::kLanes + lane], points(k, 10));
    }
  }
}

TEST(PointSet, KnowsTheLargestMagnitudeOfEachCoordinate) {
  Eigen::MatrixXd points(2, 3);
  points << 1, -5, 2, 0.5, 0.25, -0.75;
  const PointSet S(points);
  EXPECT_EQ(S.coordinate_magnitude()[0], 5);
  EXPECT_EQ(S.coordinate_magnitude()[1], 0.75);
}

RC_GTEST_PROP(PointSetProperty, IsPositivelyHomogeneous, ()) {
  Random random = random_stream();
  const int n = *rc::gen::inRange(1, 21);
  const PointSet S(gaussian_points(n, *rc::gen::inRange(1, 101), random));
  const Vector u = gaussian_points(n, 1, random);
  const double factor = std::ldexp(1.0, *rc::gen::inRange(-40, 41));
  RC_ASSERT(S.support_function(factor * u) == factor * S.support_function(u));
  RC_ASSERT(S.support_mapping(factor * u) == S.support_mapping(u));
}

RC_GTEST_PROP(PointSetProperty, IsSubadditive, ()) {
  Random random = random_stream();
  const int n = *rc::gen::inRange(1, 21);
  const PointSet S(integer_points(n, *rc::gen::inRange(1, 101), 100, random));
  const Vector u = integer_points(n, 1, 100, random);
  const Vector v = integer_points(n, 1, 100, random);
  RC_ASSERT(S.support_function(u + v) <= S.support_function(u) + S.support_function(v));
}

RC_GTEST_PROP(PointSetProperty, HasItsCenterInside, ()) {
  Random random = random_stream();
  const int n = *rc::gen::inRange(1, 21);
  const Eigen::MatrixXd points = gaussian_points(n, *rc::gen::inRange(1, 101), random);
  const PointSet S(points);
  const Vector u = gaussian_points(n, 1, random);
  RC_ASSERT(u.dot(S.center()) <=
            S.support_function(u) + static_cast<double>(points.cols()) * dot_tolerance(points, u));
}

TEST(PointSet, HasACenterEvenWhereTheSumOfItsPointsOverflows) {
  const PointSet S(Eigen::MatrixXd::Constant(2, 16, 1e308));
  EXPECT_TRUE(S.center().isApprox(Vector::Constant(2, 1e308)));
}

TEST(PointSet, NamesThePointAndTheCoordinateThatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 12);
    points(2, 9) = bad;
    try {
      const PointSet S(points);
      FAIL() << "accepted " << bad;
    } catch (const NonFiniteError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("coordinate 2"), std::string::npos) << message;
      EXPECT_NE(message.find("point 9"), std::string::npos) << message;
    }
  }
}

TEST(PointSet, RefusesToBeEmptyOrWithoutDimension) {
  EXPECT_THROW(PointSet(Eigen::MatrixXd(3, 0)), EmptySetError);
  EXPECT_THROW(PointSet(Eigen::MatrixXd(0, 3)), InvalidParameterError);
}

TEST(PointSet, RefusesAnIndexOutsideItsRange) {
  const PointSet S(cube_vertices(2));
  EXPECT_THROW(S.point(-1), InvalidParameterError);
  EXPECT_THROW(S.point(4), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_point_set
