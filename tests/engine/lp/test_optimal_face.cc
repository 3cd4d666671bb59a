// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/optimal_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engine/numerics/exact_sum.h"
#include "raygauge/sets/convex_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_optimal_face {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// `count` columns of integers of which 1 : 2 : 3 : … make e_m, up to a common factor; every other one costs.
struct Columns {
  Eigen::MatrixXd M;
  Vector weights;
};

Columns columns_with_solution(int m, int count, Random& random) {
  Columns columns{integer_points(m, count, 100, random), Vector(count)};
  for (int i = 0; i < count; ++i) columns.weights[i] = i + 1;
  columns.weights /= columns.weights.sum();
  columns.M.row(m - 1).setOnes();
  columns.M.topRows(m - 1).col(0).setZero();
  for (int i = 1; i < count; ++i)
    columns.M.topRows(m - 1).col(0) -= (i + 1) * columns.M.topRows(m - 1).col(i);
  return columns;
}

double upper_of(const Columns& columns, OptimalFace& face, double error = 0) {
  face.begin(static_cast<int>(columns.M.rows()), best_kernels());
  for (int i = 0; i < columns.M.cols(); ++i) {
    face.add(columns.M.col(i).eval().data(), i % 2, columns.weights[i] * (1 + error), i);
  }
  return face.choose(Stopwatch()) ? face.upper(Stopwatch()) : kInfinity;
}

double cost_of(const Columns& columns) {
  double cost = 0;
  for (int i = 1; i < columns.M.cols(); i += 2) cost += columns.weights[i];
  return cost;
}

TEST(OptimalFace, ProvesTheCostOfItsWeights) {
  Random random(51);
  OptimalFace face;
  for (const int m : {3, 20, 60}) {
    for (const int count : {2, 3, m / 2 + 1, m}) {
      const Columns columns = columns_with_solution(m, count, random);
      const double upper = upper_of(columns, face, 1e-6);
      EXPECT_GE(upper, cost_of(columns) * (1 - 1e-15)) << "m = " << m << ", " << count << " columns";
      EXPECT_LE(upper, cost_of(columns) * (1 + 1e-13)) << "m = " << m << ", " << count << " columns";
      for (int i = 0; i < count; ++i) EXPECT_NEAR(face.weight(i), columns.weights[i], 1e-14);
      EXPECT_TRUE(face.is_rounded());
    }
  }
}

// Weights that are not optimal, three times as many as rows: any few of the heaviest make up for the error.
TEST(OptimalFace, ProvesTheCostOfInteriorWeightsByTheHeaviestColumns) {
  Random random(53);
  OptimalFace face;
  const int m = 40, count = 120;
  const Columns columns = columns_with_solution(m, count, random);
  face.begin(m, best_kernels());
  for (int i = 0; i < count; ++i)
    face.add(columns.M.col(i).eval().data(), i % 2, columns.weights[i] * (i % 3 == 0 ? 1 + 1e-9 : 1), i);
  ASSERT_TRUE(face.choose(Stopwatch(), m + m / 4));
  EXPECT_EQ(face.rank(), m);
  EXPECT_NEAR(face.upper(Stopwatch()), cost_of(columns), 1e-7);
}

// More columns than their rank: some weights stay as they are, the others make up for it.
TEST(OptimalFace, ProvesTheCostOfDependentColumns) {
  Random random(52);
  OptimalFace face;
  Columns columns = columns_with_solution(30, 6, random);
  columns.M.conservativeResize(30, 8);
  columns.M.col(6) = 2 * columns.M.col(1) - columns.M.col(2);
  columns.M.col(7) = 2 * columns.M.col(3) - columns.M.col(4);
  Vector weights = Vector::Constant(8, 0.01);
  for (int i = 0; i < 6; ++i) weights[i] = columns.weights[i];
  columns.weights = weights;
  const double upper = upper_of(columns, face);
  EXPECT_EQ(face.rank(), 6);
  ASSERT_LT(upper, kInfinity);
  Vector left = -Vector::Unit(30, 29);
  for (int i = 0; i < 8; ++i) left += face.weight(i) * columns.M.col(i);
  EXPECT_LE(left.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(OptimalFace, ProvesNothingOfColumnsThatMissTheRightHandSide) {
  Random random(53);
  OptimalFace face;
  Columns columns = columns_with_solution(30, 6, random);
  columns.M(4, 0) += 1;
  EXPECT_EQ(upper_of(columns, face), kInfinity) << "one entry off";
  columns = columns_with_solution(30, 6, random);
  columns.M.col(0) *= -1;
  columns.M(29, 0) = 1;
  EXPECT_EQ(upper_of(columns, face), kInfinity) << "a negative weight";
}

TEST(OptimalFace, EnclosesDirectionsThatAreOrthogonalToItsColumns) {
  Random random(54);
  OptimalFace face;
  const int n = 20;
  Vector y = integer_points(n, 1, 3, random).col(0);
  y[0] = 1;
  face.begin(n, best_kernels());
  for (int i = 0; i < 8; ++i) {
    Vector p = integer_points(n, 1, 50, random).col(0);
    p[0] -= y.dot(p);
    face.add(p.data(), 0, 1, i);
  }
  Vector u = y + 1e-9 * gaussian_points(n, 1, random).col(0);
  ASSERT_TRUE(face.choose(Stopwatch()));
  Vector u_low(n);
  const double error = face.enclose_orthogonal(u.data(), u_low.data(), Stopwatch());
  ASSERT_LT(error, 1e-25);
  for (int i = 0; i < 8; ++i) {
    const Vector p = Vector::Map(face.column(i), n);
    ExactSum product;
    for (int k = 0; k < n; ++k) {
      product.add_product(u[k], p[k]);
      product.add_product(u_low[k], p[k]);
    }
    EXPECT_LE(std::fabs(product.rounded().value), 1.01 * error * p.cwiseAbs().sum());
  }
  EXPECT_LE((u - y).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(OptimalFace, LeavesOutWhatDependsOnTheOthers) {
  Eigen::MatrixXd M(
      3, 5);  // 0 = the mean of (1, 0) and (-1, 0), and of (0, 1), which is here twice, and (0, -1)
  M << 1, -1, 0, 0, 0, 0, 0, 1, 1, -1, 1, 1, 1, 1, 1;
  const double weights[] = {0.125, 0.125, 0.25, 0.125, 0.375};
  OptimalFace face;
  face.begin(3, best_kernels());
  for (int i = 0; i < 5; ++i) face.add(M.col(i).eval().data(), 0, weights[i], i);
  ASSERT_TRUE(face.is_independent_zero(Stopwatch()));
  EXPECT_EQ(face.count(), face.rank());
  Vector sum = Vector::Zero(3);
  for (int i = 0; i < face.count(); ++i) {
    EXPECT_GT(face.weight(i), 0);
    sum += face.weight(i) * M.col(face.id(i));
  }
  EXPECT_EQ(sum, Vector::Unit(3, 2));
  EXPECT_TRUE(face.is_rounded());
}

TEST(OptimalFace, IsNoZeroWhereItsColumnsMissTheOrigin) {
  Eigen::MatrixXd M(3, 2);
  M << 1, -1, 0x1p-40, 0, 1, 1;
  OptimalFace face;
  face.begin(3, best_kernels());
  for (int i = 0; i < 2; ++i) face.add(M.col(i).eval().data(), 0, 0.5, i);
  EXPECT_FALSE(face.is_independent_zero(Stopwatch()));
}

}  // namespace
}  // namespace raygauge::test_optimal_face
