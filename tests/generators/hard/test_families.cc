// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What sets one hard family apart from another, besides its exact distance.
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/exceptions.h"
#include "tests/generators/hard/brute_force.h"
#include "tests/generators/points_of.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_families {
namespace {

TEST(HardPlantedTies, AllPointsLieOnTheOptimalHyperplaneIfAsked) {
  const Instance instance = generate("hard_planted_ties", {1, 6, 40, 0}, {{"ties", 1.0}});
  const Eigen::MatrixXd Q = points_of(instance.Q);
  const Eigen::MatrixXd edges = Q.rightCols(39).colwise() - Q.col(0);
  EXPECT_EQ(rank(edges), 5);
}

TEST(HardPlantedTies, HasNPointsOfIntegersInFiftyDimensions) {
  const Instance instance = generate("hard_planted_ties", {1, 50, 200, 0});
  const Eigen::MatrixXd A = points_of(instance.A);
  EXPECT_EQ(A.cols(), 200);
  EXPECT_EQ(A, A.array().round().matrix());
}

TEST(HardPlantedUnimodular, StaysExactInFiftyDimensions) {
  const Instance instance =
      generate("hard_planted_unimodular", {1, 50, 200, 0}, {{"entry", std::int64_t{10000}}});
  EXPECT_LT(points_of(instance.A).cwiseAbs().maxCoeff(), 0x1p53);
  EXPECT_GT(points_of(instance.Q).cwiseAbs().maxCoeff(), 1e5);
}

TEST(HardNeedle, ShearedByARoundedAspectClaimsNothing) {
  EXPECT_FALSE(generate("hard_needle", {1, 3, 1, 0}, {{"sheared", true}}).exact_distance.has_value());
}

TEST(HardLattice, TooManyPointsAreRefused) {
  EXPECT_THROW(generate("hard_lattice", {1, 17, 1, 0}, {{"k", std::int64_t{1}}}), InvalidParameterError);
  EXPECT_THROW(generate("hard_lattice", {1, 50, 1, 0}, {{"k", std::int64_t{255}}}), InvalidParameterError);
  EXPECT_EQ(points_of(generate("hard_lattice", {1, 16, 1, 0}, {{"k", std::int64_t{1}}}).A).cols(), 65536);
}

TEST(HardMomentCurve, HasPowersForCoordinates) {
  const Eigen::MatrixXd A = points_of(generate("hard_moment_curve", {1, 4, 30, 0}).A);
  const Eigen::MatrixXd Q = points_of(generate("hard_moment_curve", {1, 4, 30, 0}).Q);
  EXPECT_LT(Q.rowwise().mean().cwiseAbs().maxCoeff(), 1e-15);
  const Eigen::MatrixXd edges = A.colwise() - A.col(0);
  // Differences of t, t², t³ between points i and 0 determine t_0: (t_i² - t_0²) / (t_i - t_0) = t_i + t_0.
  const double sum_1 = edges(1, 1) / edges(0, 1);
  const double t_0 = (sum_1 - edges(0, 1)) / 2, t_1 = (sum_1 + edges(0, 1)) / 2;
  EXPECT_NEAR(edges(2, 1), std::pow(t_1, 3) - std::pow(t_0, 3), 1e-13);
  EXPECT_NEAR(edges(3, 1), std::pow(t_1, 4) - std::pow(t_0, 4), 1e-13);
}

TEST(HardPolygons, TheDistanceDoesNotDependOnFurtherAxes) {
  const Instance plane = generate("hard_polygons", {1, 2, 5, 0});
  const auto d = brute_force_distance(points_of(plane.A), points_of(plane.Q));
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 7), Q = Eigen::MatrixXd::Zero(3, 7);
  A.topLeftCorner(2, 5) = points_of(plane.A);
  Q.topLeftCorner(2, 5) = points_of(plane.Q);
  const Instance space = generate("hard_polygons", {1, 3, 5, 0});
  // The key differs in n, hence the direction of A: take the bipyramids' apexes over the plane's polygons.
  Q.rightCols(2) = points_of(space.Q).rightCols(2);
  A.rightCols(2) = Q.rightCols(2);
  A.topRightCorner(2, 2).colwise() = Vector(points_of(plane.A).rowwise().mean());
  ASSERT_TRUE(d.has_value());
  EXPECT_NEAR(static_cast<double>(*brute_force_distance(A, Q)), static_cast<double>(*d), 1e-14);
}

TEST(HardPolygons, FewerThanThreePointsAreRefused) {
  EXPECT_THROW(generate("hard_polygons", {1, 2, 2, 0}), InvalidParameterError);
}

TEST(HardMinkowskiDifference, IsTheDifferenceOfSpheresFourApart) {
  const Eigen::MatrixXd A = points_of(generate("hard_minkowski_difference", {1, 3, 400, 0}).A);
  ASSERT_EQ(A.cols(), 400);
  // |p - q| of points on unit spheres with centres 4 apart, rounded to 2^-26 at 1e8.
  EXPECT_GT(A.colwise().norm().minCoeff(), 2 - 1e-6);
  EXPECT_LT(A.colwise().norm().maxCoeff(), 6 + 1e-6);
}

TEST(HardMinkowskiDifference, HoldsTheRoundingOfItsOffset) {
  const Eigen::MatrixXd A =
      points_of(generate("hard_minkowski_difference", {1, 3, 16, 0}, {{"offset", 0x1p40}}).A);
  const Eigen::MatrixXd grid = A * 0x1p20;
  EXPECT_EQ(grid, grid.array().round().matrix());
}

TEST(HardLowRank, ASpansAFlatOfTheRankAskedFor) {
  for (const int rank : {0, 1, 3, 9}) {
    const Parameters parameters = {{"rank", std::int64_t{rank}}};
    const Eigen::MatrixXd A = points_of(generate("hard_low_rank", {1, 5, 30, 0}, parameters).A);
    const Eigen::MatrixXd edges = A.colwise() - A.col(0);
    EXPECT_EQ(raygauge::rank(edges), std::min(rank, 5));
  }
}

TEST(HardFamilies, WithoutAClosedFormClaimNoDistance) {
  for (const char* name :
       {"hard_moment_curve", "hard_polygons", "hard_minkowski_difference", "hard_low_rank"}) {
    EXPECT_FALSE(generate(name, {1, 3, 9, 0}).exact_distance.has_value()) << name;
  }
}

}  // namespace
}  // namespace raygauge::test_families
