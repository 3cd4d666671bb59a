// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/example2.h"

#include <gtest/gtest.h>

#include "tests/generators/points_of.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_example2 {
namespace {

// Of coordinates of size 1.
constexpr double kRounding = 1e-15;

TEST(Example2, PutsThePointsOfQOnTheUnitSphere) {
  for (const int n : {1, 2, 3, 10, 50}) {
    const Eigen::MatrixXd Q = points_of(generate("example2", {1, n, 200, 0}).Q);
    ASSERT_EQ(Q.rows(), n);
    ASSERT_EQ(Q.cols(), 200);
    EXPECT_LT((Q.colwise().norm().array() - 1).abs().maxCoeff(), kRounding) << n;
  }
}

// The centre c is what all points are at distance 1 from: 2 (a_i - a_0)·c = |a_i|² - |a_0|².
TEST(Example2, PutsThePointsOfAOnAUnitSphereAtTheGivenSeparation) {
  for (const double separation : {1.0, 1 + 1e-6, 1.5, 50.0}) {
    const Eigen::MatrixXd A = points_of(generate("example2", {1, 3, 200, 0}, {{"separation", separation}}).A);
    const Eigen::MatrixXd edges = (A.colwise() - A.col(0)).transpose();
    const Vector squares = (A.colwise().squaredNorm().array() - A.col(0).squaredNorm()).matrix().transpose();
    const Vector center = solution(edges, squares / 2);
    EXPECT_NEAR(center.norm(), 2 * separation, 1e-11 * separation);
    EXPECT_LT(((A.colwise() - center).colwise().norm().array() - 1).abs().maxCoeff(), 1e-11 * separation);
  }
}

TEST(Example2, SeparationMovesAAlongALineAndNothingElse) {
  const Instance near = generate("example2", {3, 4, 20, 5}, {{"separation", 2.0}});
  const Instance far = generate("example2", {3, 4, 20, 5}, {{"separation", 50.0}});
  EXPECT_EQ(points_of(near.Q), points_of(far.Q));
  const Eigen::MatrixXd shift = points_of(far.A) - points_of(near.A);
  EXPECT_LT((shift.colwise() - shift.col(0)).cwiseAbs().maxCoeff(), 100 * kRounding);
  EXPECT_NEAR(shift.col(0).norm(), 96, 100 * kRounding);
}

TEST(Example2, ReproducesItsGoldenPoint) {
  const Instance instance = generate("example2", {1, 3, 200, 0});
  EXPECT_EQ(points_of(instance.Q)(2, 199), -0x1.eda0904a7448p-3);
  EXPECT_EQ(points_of(instance.A)(0, 0), -0x1.41f4bf719fcb8p-3);
}

TEST(Example2, ClaimsNoExactDistance) {
  EXPECT_FALSE(generate("example2", {1, 3, 20, 0}).exact_distance.has_value());
}

}  // namespace
}  // namespace raygauge::test_example2
