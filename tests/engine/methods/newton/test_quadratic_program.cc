// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/newton/quadratic_program.h"

#include <gtest/gtest.h>

#include "engine/methods/newton/sqp_oracle.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"

namespace raygauge::test_quadratic_program {
namespace {

Ellipsoid ellipsoid(const Vector& center, double a, double b, double c) {
  return {center, Eigen::MatrixXd(Eigen::Vector3d(a, b, c).asDiagonal())};
}

TEST(SqpOracle, GivesSupportPointAndHessianOfASmoothSet) {
  const Ellipsoid S = ellipsoid(Vector{{1.0, 2.0, 3.0}}, 1, 2, 0.5);
  SqpOracle<double> oracle;
  ASSERT_TRUE(oracle.bind(S, -1.0, best_kernels()));
  const Eigen::Vector3d u(0.3, -0.8, 0.52);
  PieceList<double> list;
  ASSERT_TRUE(oracle.evaluate(u.data(), list));
  ASSERT_EQ(list.count, 1);
  Vector s(3);
  const Eigen::Vector3d minus = -u;
  EXPECT_NEAR(list.support.value, S.support_unchecked(minus.data(), s.data()), 1e-14) << "h(-u)";
  const Eigen::Map<const Eigen::Matrix3d> H(list.hessian(0));
  EXPECT_LT((H * u).norm(), 1e-14) << "h is homogeneous";
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(list.point(0)[k], s[k], 1e-14);
    const double step = 1e-6;
    Eigen::Vector3d near = minus;
    near[k] += step;
    Vector moved(3);
    S.support_unchecked(near.data(), moved.data());
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(H(j, k), (moved[j] - s[j]) / step, 1e-5);
  }
}

TEST(SqpOracle, RemembersTheVerticesOfAPolytope) {
  const Box S(Vector{{-1.0, -1.0}}, Vector{{1.0, 1.0}});
  SqpOracle<double> oracle;
  ASSERT_TRUE(oracle.bind(S, 1.0, best_kernels()));
  PieceList<double> list;
  const double first[2] = {1, 0.5}, second[2] = {1, -0.5};
  ASSERT_TRUE(oracle.evaluate(first, list));
  EXPECT_EQ(list.count, 1);
  ASSERT_TRUE(oracle.evaluate(second, list));
  ASSERT_EQ(list.count, 2);
  EXPECT_EQ(list.value[static_cast<std::size_t>(list.best)], 1.5);
  EXPECT_FALSE(list.curved);
}

// At the step the model's gradient is a multiple of u: nothing is left to gain across u. Along u the
// functions are linear, and how far the step goes is of no account.
TEST(QuadraticProgram, StepsToTheMinimumOfASmoothModel) {
  const Ellipsoid A = ellipsoid(Vector{{3.0, 1.0, 0.0}}, 1, 2, 0.5);
  const Ellipsoid Q = ellipsoid(Vector{{0.0, 0.0, 0.0}}, 1, 0.7, 2);
  SqpOracle<double> oracle_A, oracle_Q;
  ASSERT_TRUE(oracle_A.bind(A, 1.0, best_kernels()));
  ASSERT_TRUE(oracle_Q.bind(Q, -1.0, best_kernels()));
  const Eigen::Vector3d u = Eigen::Vector3d(-0.9, -0.3, 0.1).normalized();
  PieceList<double> pieces_A, pieces_Q;
  ASSERT_TRUE(oracle_A.evaluate(u.data(), pieces_A));
  ASSERT_TRUE(oracle_Q.evaluate(u.data(), pieces_Q));
  QuadraticProgram<double> program;
  program.begin(3);
  QuadraticProgram<double>::Objective objective;
  objective.weight_Q = 1.4;
  const double* step = program.solve(u.data(), objective, pieces_A, pieces_Q);
  ASSERT_NE(step, nullptr);
  const Eigen::Map<const Eigen::Vector3d> d(step);
  const Eigen::Map<const Eigen::Matrix3d> H_A(pieces_A.hessian(0)), H_Q(pieces_Q.hessian(0));
  const Eigen::Map<const Eigen::Vector3d> s_A(pieces_A.point(0)), s_Q(pieces_Q.point(0));
  const Eigen::Vector3d gradient = (H_A + 1.4 * H_Q) * d + s_A - 1.4 * s_Q;
  EXPECT_LT((gradient - gradient.dot(u) * u).norm(), 1e-10 * gradient.norm());
  EXPECT_EQ(pieces_A.weight[0], 1);
  EXPECT_EQ(program.systems(), 1);
}

// The side of a capsule beside the end of another.
TEST(QuadraticProgram, SharesWeightsAmongThePiecesThatAttainTheMaximum) {
  const Capsule A(Vector{{3.0, -1.0}}, Vector{{3.0, 1.0}}, 0.5);
  const Capsule Q(Vector{{-1.0, 0.0}}, Vector{{1.0, 0.0}}, 0.25);
  SqpOracle<double> oracle_A, oracle_Q;
  ASSERT_TRUE(oracle_A.bind(A, 1.0, best_kernels()));
  ASSERT_TRUE(oracle_Q.bind(Q, -1.0, best_kernels()));
  const double u[2] = {-1, 0};
  PieceList<double> pieces_A, pieces_Q;
  ASSERT_TRUE(oracle_A.evaluate(u, pieces_A));
  ASSERT_TRUE(oracle_Q.evaluate(u, pieces_Q));
  ASSERT_EQ(pieces_A.count, 2) << "both ends of the segment";
  QuadraticProgram<double> program;
  program.begin(2);
  const double* step = program.solve(u, {}, pieces_A, pieces_Q);
  ASSERT_NE(step, nullptr);
  EXPECT_NEAR(step[1], 0, 1e-12) << "u is the normal of the contact";
  EXPECT_NEAR(pieces_A.weight[0], 0.5, 1e-12);
  EXPECT_NEAR(pieces_A.weight[1], 0.5, 1e-12);
  EXPECT_EQ(pieces_A.active_count, 2);
}

}  // namespace
}  // namespace raygauge::test_quadratic_program
