// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/common_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/engine/point_clouds.h"

namespace raygauge::test_common_ray {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

CommonRay ray_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  ColumnPool a, q;
  a.clear(static_cast<int>(A.rows()));
  q.clear(static_cast<int>(Q.rows()));
  for (Eigen::Index i = 0; i < A.cols(); ++i) a.add(A.col(i).data());
  for (Eigen::Index j = 0; j < Q.cols(); ++j) q.add(Q.col(j).data());
  CommonRay ray;
  ray.find(a, q, static_cast<int>(A.rows()));
  return ray;
}

TEST(CommonRay, IsTheOneOfTheLeastMultiple) {
  Random random(5);
  Eigen::MatrixXd A = gaussian_points(6, 40, random), Q = gaussian_points(6, 30, random);
  EXPECT_EQ(ray_of(A, Q).upper(), kInfinity);
  A.col(7) = 3 * (1024 * Q.col(21));
  A.col(3) = 0.75 * Q.col(4);
  A.col(11) = -0.5 * Q.col(4);  // on the other side
  // Products with 3 and 0.75 round: only with few bits are they on the ray.
  EXPECT_EQ(ray_of(A, Q).upper(), kInfinity);
  A.col(7) = 1024 * Q.col(21);
  A.col(3) = 0.5 * Q.col(4);
  const CommonRay ray = ray_of(A, Q);
  EXPECT_EQ(ray.point_of_A(), 3);
  EXPECT_EQ(ray.ratio(), 0.5);
  EXPECT_EQ(ray.upper(), std::nextafter(0.5, 1.0));
}

TEST(CommonRay, OfIntegersHoldsForAnyRationalMultiple) {
  Eigen::MatrixXd A(3, 2), Q(3, 3);
  A << 1, 14, 1, -21, 1, 0;
  Q << 0, 6, 0, 5, -9, 0, 0, 0, 0;
  const CommonRay ray = ray_of(A, Q);
  EXPECT_EQ(ray.point_of_A(), 1);
  EXPECT_LT(ray.ratio() - 7 / 3.0, 1e-15);
  EXPECT_GE(3 * ray.upper(), 7);
}

TEST(CommonRay, IsNoneOfPointsThatAreNearlyOnOne) {
  Eigen::MatrixXd A(2, 1), Q(2, 1);
  Q << 1, 1.0 / 3;
  A << 3, 1;  // the last bit of 1/3 is rounded
  EXPECT_EQ(ray_of(A, Q).upper(), kInfinity);
  A << 1e-320, 1e-320 / 3;  // products that underflow prove nothing
  EXPECT_EQ(ray_of(A, Q).upper(), kInfinity);
  A << 0, 0;  // no ray
  EXPECT_EQ(ray_of(A, Q).upper(), kInfinity);
}

}  // namespace
}  // namespace raygauge::test_common_ray
