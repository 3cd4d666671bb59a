// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/gauge_lp.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/baselines/point_set_instances.h"

namespace raygauge::testing::test_gauge_lp {
namespace {

class Disc final : public ConvexSet {
 public:
  Disc() : ConvexSet(2) {}

 private:
  double do_support(const double* u, double* point) const override {
    const double length = std::hypot(u[0], u[1]);
    for (int k = 0; k < 2; ++k) point[k] = length > 0 ? u[k] / length : 0;
    return length;
  }
  void do_center(double* point) const override { point[0] = point[1] = 0; }
};

TEST(GaugeLp, ColumnsArePointsOfAWithOneAndNegatedPointsOfQWithZero) {
  const GaugeLp lp(instance(points({{5, 6}, {7, 8}}), points({{1, 2}, {-3, 4}, {0, -1}})), "m");
  ASSERT_EQ(lp.rows(), 3);
  ASSERT_EQ(lp.columns(), 5);
  Matrix columns(3, 5);
  for (int j = 0; j < 5; ++j) lp.copy_column(j, columns.col(j).data());
  Matrix expected(3, 5);
  expected << 5, 7, -1, 3, 0,  //
      6, 8, -2, -4, 1,         //
      1, 1, 0, 0, 0;
  EXPECT_EQ(columns, expected);
  EXPECT_EQ(lp.cost(1), 0);
  EXPECT_EQ(lp.cost(2), 1);
  EXPECT_EQ(lp.right_hand_side(1), 0);
  EXPECT_EQ(lp.right_hand_side(2), 1);
}

TEST(GaugeLp, SaysWhichSetIsNotAPointSet) {
  Instance mixed = instance(points({{5, 6}}), points({{1, 2}}));
  mixed.Q = std::make_shared<Disc>();
  try {
    GaugeLp(mixed, "glpk_primal");
    FAIL() << "accepted a disc";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(), "method 'glpk_primal' takes point sets only, and Q is not a point set");
  }
}

TEST(GaugeLp, RefusesSetsOfDifferentDimension) {
  EXPECT_THROW(GaugeLp(instance(points({{5, 6}}), points({{1, 2, 3}})), "m"), DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::testing::test_gauge_lp
