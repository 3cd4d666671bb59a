// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/numerics/dense.h"

#include <gtest/gtest.h>

#include <utility>

namespace raygauge::test_dense {
namespace {

const Eigen::MatrixXd kMatrix{{1, 2, 3}, {4, 5, 6}};

TEST(Dense, TakesTheValuesOfAnyExpression) {
  const Vector column = 2 * kMatrix.col(1);
  EXPECT_EQ(column, Eigen::VectorXd({{4, 10}}));
  const DenseMatrix product = kMatrix.transpose() * kMatrix;
  EXPECT_EQ(product, kMatrix.transpose() * kMatrix);
}

TEST(Dense, MakesAColumnOfARow) {
  const Vector made = kMatrix.row(1);
  EXPECT_EQ(made, Eigen::VectorXd({{4, 5, 6}}));
  Vector assigned;
  assigned = kMatrix.colwise().sum();
  EXPECT_EQ(assigned, Eigen::VectorXd({{5, 7, 9}}));
}

TEST(Dense, IsAssignedWhatRefersToItself) {
  Vector v{{1, 2, 3}};
  v = v.head(2);
  EXPECT_EQ(v, Eigen::VectorXd({{1, 2}}));
  DenseMatrix M = kMatrix;
  M = M.transpose() * M;
  EXPECT_EQ(M, kMatrix.transpose() * kMatrix);
}

TEST(Dense, KeepsItsMemoryWhereTheSizeStays) {
  Vector v(3);
  EXPECT_TRUE(v.isZero(0));
  const double* memory = v.data();
  v = kMatrix.row(0);
  v = Vector::Ones(3);
  v.resize(3);
  EXPECT_EQ(v.data(), memory);
  v.setZero(2);
  EXPECT_EQ(v.size(), 2);
}

TEST(Dense, MovesAndSwapsItsNumbers) {
  Vector a{{1, 2}}, b{{3, 4, 5}};
  swap(a, b);
  EXPECT_EQ(a.size(), 3);
  EXPECT_EQ(b[1], 2);
  const Vector moved = std::move(a);
  EXPECT_EQ(moved[2], 5);
  Vector copy = moved;
  copy[0] = 7;
  EXPECT_EQ(moved[0], 3);
  const Eigen::VectorXd out = copy;
  EXPECT_EQ(out[0], 7);
}

}  // namespace
}  // namespace raygauge::test_dense
