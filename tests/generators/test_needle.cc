// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/needle.h"

#include <gtest/gtest.h>

#include "tests/generators/points_of.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_needle {
namespace {

TEST(Needle, AspectOneLeavesUnitSpheres) {
  const Instance instance = generate("needle", {1, 3, 50, 0}, {{"aspect", 1.0}, {"separation", 50.0}});
  EXPECT_LT((points_of(instance.Q).colwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
  EXPECT_NEAR(points_of(instance.A).rowwise().mean().norm(), 100, 1);
}

// The map is I + (aspect - 1) w wᵀ: symmetric, of trace aspect + n - 1, and of determinant aspect.
TEST(Needle, StretchesBothSetsByOneMapAlongOneDirection) {
  const Parameters round = {{"aspect", 1.0}}, long_and_thin = {{"aspect", 1e6}};
  const Instance before = generate("needle", {1, 3, 50, 0}, round);
  const Instance after = generate("needle", {1, 3, 50, 0}, long_and_thin);
  const Eigen::Matrix3d Q = points_of(before.Q).leftCols(3), mapped_Q = points_of(after.Q).leftCols(3);
  Eigen::Matrix3d map;  // map Q = mapped_Q, row by row
  for (int row = 0; row < 3; ++row) {
    map.row(row) = solution(Q.transpose(), mapped_Q.row(row).transpose()).transpose();
  }
  const Eigen::MatrixXd error = map * points_of(before.A) - points_of(after.A);
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(map.trace(), 1e6 + 2, 1e-7);
  EXPECT_LT((map - map.transpose()).cwiseAbs().maxCoeff(), 1e-7);
  const Vector stretched = map.rowwise().norm() / (map.rowwise().norm()).norm();
  EXPECT_LT((map.cwiseAbs() - 1e6 * stretched * stretched.transpose()).cwiseAbs().maxCoeff(), 2);
}

}  // namespace
}  // namespace raygauge::test_needle
