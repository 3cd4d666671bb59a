// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/isotropic_map.h"

#include <gtest/gtest.h>

#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_isotropic_map {
namespace {

Eigen::MatrixXd needle(int n, int N, double aspect, Random& random) {
  const Eigen::MatrixXd points = sphere_points(n, N, random);
  const Vector w = sphere_points(n, 1, random);
  return points + (aspect - 1) * w * (w.transpose() * points);
}

TEST(IsotropicMap, MakesTheSecondMomentsTheIdentity) {
  Random random(71);
  for (const int n : {2, 3, 10, 30}) {
    for (const double aspect : {30.0, 1e4}) {
      const Eigen::MatrixXd points = needle(n, 50 * n, aspect, random);
      const auto map = isotropic_map(points);
      ASSERT_TRUE(map) << "n = " << n << ", aspect " << aspect;
      const Eigen::MatrixXd white = map->inverse * points;
      const Eigen::MatrixXd moments = white * white.transpose() / static_cast<double>(points.cols());
      // What Cholesky loses: n u κ(Σ).
      EXPECT_LT((moments - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(),
                n * 2.3e-16 * aspect * aspect);
      EXPECT_LT((map->F * map->inverse - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-11);
    }
  }
}

TEST(IsotropicMap, IsLeftOutWhereItIsNotNeededOrNotToBeHad) {
  Random random(72);
  const Eigen::MatrixXd round = sphere_points(5, 200, random);
  EXPECT_FALSE(isotropic_map(round));
  EXPECT_FALSE(isotropic_map(needle(5, 9, 1e4, random))) << "fewer than 2n points";
  EXPECT_FALSE(isotropic_map(needle(5, 200, 1e9, random))) << "too flat for doubles";
  Eigen::MatrixXd flat = round;
  flat.row(2).setZero();
  EXPECT_FALSE(isotropic_map(flat));
  EXPECT_FALSE(isotropic_map(Eigen::MatrixXd::Zero(5, 200)));
  EXPECT_FALSE(isotropic_map(Eigen::MatrixXd::Random(1, 200)));
}

TEST(IsotropicMap, KnowsNoScale) {
  Random random(73);
  const Eigen::MatrixXd points = needle(4, 200, 1e3, random);
  const auto map = isotropic_map(points);
  ASSERT_TRUE(map);
  for (const double factor : {0x1p-900, 0x1p900}) {
    const auto scaled = isotropic_map(factor * points);
    ASSERT_TRUE(scaled);
    EXPECT_EQ(scaled->F, factor * map->F);
    EXPECT_EQ(scaled->inverse, map->inverse / factor);
  }
}

TEST(IsotropicMap, IsMadeOfASampleOfALargeSet) {
  Random random(74);
  const PointSet large(needle(3, 30000, 100, random));
  ASSERT_NE(large.isotropic(), nullptr);
  EXPECT_NEAR(determinant(large.isotropic()->F), 100 / std::pow(3, 1.5), 2);
}

}  // namespace
}  // namespace raygauge::test_isotropic_map
