// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/maps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/generators/hard/brute_force.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_maps {
namespace {

RandomStream stream_of(int repetition) {
  return RandomStream({1, 3, 1, repetition}, "test_maps", RandomPurpose::shape);
}

TEST(Maps, AUnimodularMapHasLargeEntriesAndAnIntegerInverse) {
  for (const int n : {2, 3, 4}) {
    PointClouds clouds{Eigen::MatrixXd::Identity(n, n), Eigen::MatrixXd::Identity(n, n)};
    RandomStream stream = stream_of(n);
    apply_unimodular(clouds, stream, 1000);
    EXPECT_EQ(clouds.A, clouds.Q);
    EXPECT_LE(clouds.A.cwiseAbs().maxCoeff(), 1000);
    EXPECT_GT(clouds.A.cwiseAbs().maxCoeff(), 300);
    EXPECT_EQ(clouds.A, clouds.A.array().round().matrix());
    EXPECT_NEAR(determinant(clouds.A), 1,
                1e-3);  // an integer, computed with entries of 1e3 to the n-th power
  }
}

TEST(Maps, AUnimodularMapOfTheLineIsTheIdentity) {
  PointClouds clouds{Eigen::MatrixXd::Constant(1, 1, 7), Eigen::MatrixXd::Constant(1, 1, 2)};
  RandomStream stream = stream_of(0);
  apply_unimodular(clouds, stream, 1000);
  EXPECT_EQ(clouds.A(0, 0), 7);
}

TEST(Maps, TurnedAxesAreASignedPermutationOfBothSets) {
  PointClouds clouds{Eigen::MatrixXd::Identity(5, 5), Eigen::MatrixXd::Identity(5, 5)};
  RandomStream stream = stream_of(1);
  turn_axes(clouds, stream);
  EXPECT_EQ(clouds.A, clouds.Q);
  EXPECT_EQ(clouds.A.transpose() * clouds.A, Eigen::MatrixXd::Identity(5, 5));
  EXPECT_EQ(clouds.A.cwiseAbs().sum(), 5);
}

TEST(Maps, RepeatingKeepsEveryPointAsOftenAsAsked) {
  Eigen::MatrixXd points(1, 3);
  points << 1, 2, 3;
  RandomStream stream = stream_of(2);
  const Eigen::MatrixXd repeated = repeated_and_shuffled(points, 50, stream);
  ASSERT_EQ(repeated.cols(), 150);
  for (const double value : {1.0, 2.0, 3.0}) EXPECT_EQ((repeated.array() == value).count(), 50);
  EXPECT_FALSE(std::is_sorted(repeated.row(0).begin(), repeated.row(0).end()));
}

TEST(Maps, ScalingByAPowerOfTwoIsUndoneByItsInverse) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Constant(2, 2, 1.0 / 3);
  EXPECT_EQ(scaled_by_power_of_two(scaled_by_power_of_two(points, -900), 900), points);
}

}  // namespace
}  // namespace raygauge::test_maps
