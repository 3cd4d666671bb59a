// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/clustered.h"

#include <gtest/gtest.h>

#include "tests/generators/points_of.h"

namespace raygauge::test_clustered {
namespace {

TEST(Clustered, PointsOfOneClusterAreNearEachOtherAndThoseOfItsPartnerOpposite) {
  const Parameters parameters = {{"clusters", std::int64_t{4}}, {"spread", 1e-3}};
  const Eigen::MatrixXd Q = points_of(generate("clustered", {1, 6, 40, 0}, parameters).Q);
  for (Eigen::Index i = 0; i < 40; ++i) {
    // |g| / √n exceeds 6 with negligible probability.
    EXPECT_LT((Q.col(i) - Q.col(i % 4)).norm(), 12e-3);
    EXPECT_LT((Q.col(i) + Q.col((i + 1 - 2 * (i % 2)) % 40)).norm(), 12e-3);
    EXPECT_NEAR(Q.col(i).norm(), 1, 1e-15);
  }
  EXPECT_GT((Q.col(0) - Q.col(2)).norm(), 0.1);
}

TEST(Clustered, SeparatesTheSpheresAsExample2Does) {
  const Eigen::MatrixXd A = points_of(generate("clustered", {1, 4, 64, 0}, {{"separation", 50.0}}).A);
  // Antipodal clusters: the mean of the points is the centre up to the spread.
  EXPECT_NEAR(A.rowwise().mean().norm(), 100, 0.05);
}

}  // namespace
}  // namespace raygauge::test_clustered
