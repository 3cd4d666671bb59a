// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_columns.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/baselines/point_set_instances.h"

namespace raygauge::testing::test_exact_columns {
namespace {

IntegerVector column(const ExactColumns& columns, std::ptrdiff_t j) {
  IntegerVector result;
  columns.copy(j, result);
  return result;
}

TEST(ExactColumns, RowsAreScaledToIntegersByTheLeastPowerOfTwo) {
  const PointSet A(points({{0.75, 8}})), Q(points({{2, -24}, {0, 0}}));
  const ExactColumns columns(A, Q);
  EXPECT_EQ(columns.shift(0), 2);
  EXPECT_EQ(columns.shift(1), -3);
  EXPECT_EQ(column(columns, 0), (IntegerVector{3, 1, 1, 0}));
  EXPECT_EQ(column(columns, 1), (IntegerVector{-8, 3, 0, 1}));
  EXPECT_EQ(column(columns, 2), (IntegerVector{0, 0, 0, 1}));
}

TEST(ExactColumns, RefuseSetsOfDifferentDimension) {
  const PointSet A(points({{1, 2}})), Q(points({{1}}));
  EXPECT_THROW(ExactColumns(A, Q), DimensionMismatchError);
}

TEST(ExactProduct, SignIsExactWhereRoundingCancelsEverything) {
  // p·a = 2^80 - (2^80 - 1) = 1, then 0, then -1, in numbers of which doubles keep 53 bits only.
  const PointSet A(points({{1, 1}})), Q(points({{1, 1}}));
  const ExactColumns columns(A, Q);
  const Integer big = Integer(1) << 80U;
  for (const int expected : {1, 0, -1}) {
    const IntegerVector p = {big, -big, expected, 0};
    EXPECT_EQ(ExactProduct(columns, p).sign(0).sign, expected);
    EXPECT_EQ(ExactProduct(columns, p).exact(0), Integer(expected));
  }
}

TEST(ExactProduct, SignIsExactWhereExponentsExceedLongDouble) {
  const PointSet A(points({{1, 1}})), Q(points({{1, 1}}));
  const ExactColumns columns(A, Q);
  const Integer huge = Integer(1) << 40000U;
  const IntegerVector p = {huge, -huge, -1, 0};
  EXPECT_EQ(ExactProduct(columns, p).sign(0).sign, -1);
  EXPECT_EQ(ExactProduct(columns, p).sign(1).sign, 0);
}

TEST(ExactProduct, SignAgreesWithTheExactProductOnRandomData) {
  const Instance sets = two_spheres(5, 4, 60);
  const ExactColumns columns(dynamic_cast<const PointSet&>(*sets.A), dynamic_cast<const PointSet&>(*sets.Q));
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 20; ++trial) {
    IntegerVector p(6);
    for (Integer& x : p) x = static_cast<std::int64_t>(random());
    ExactProduct product(columns, p);
    for (std::ptrdiff_t j = 0; j < columns.count(); ++j) {
      ASSERT_EQ(product.sign(j).sign, product.exact(j).sign());
    }
  }
}

TEST(ExactProduct, OfTheZeroVectorIsZero) {
  const PointSet A(points({{3, 4}})), Q(points({{1, 1}}));
  const ExactColumns columns(A, Q);
  const IntegerVector p(4);
  ExactProduct product(columns, p);
  EXPECT_TRUE(product.is_zero());
  EXPECT_EQ(product.sign(0).sign, 0);
}

}  // namespace
}  // namespace raygauge::testing::test_exact_columns
