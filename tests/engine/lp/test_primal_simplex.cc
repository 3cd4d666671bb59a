// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/primal_simplex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "engine/numerics/stopwatch.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_primal_simplex {
namespace {

struct Program {
  PointSet A, Q;
  ColumnPool pool_A, pool_Q;
  Vector guess;
  Stopwatch stopwatch;
  PrimalSimplex simplex;

  Program(const Eigen::MatrixXd& points_A, const Eigen::MatrixXd& points_Q, const Kernels& kernels,
          std::int64_t max_pivots = 0)
      : A(points_A), Q(points_Q), guess(Vector::Zero(points_A.rows())) {
    const int n = A.dimension();
    const Vector ones = Vector::Ones(n);
    pool_A.choose(A, ones.data(), true, false);
    pool_Q.choose(Q, ones.data(), true, false);
    guess[0] = -1;
    simplex.begin(n, 1e-14, max_pivots, kernels);
    simplex.start(pool_A, pool_Q, {guess.data(), 0.1});
  }

  // As the callers do: bounds on the normal that stay active are raised.
  PrimalSimplex::End solve() {
    for (;;) {
      const PrimalSimplex::End end = simplex.solve(pool_A, pool_Q, stopwatch);
      if (end != PrimalSimplex::End::bounded) return end;
      simplex.raise_bounds();
    }
  }
};

// max u·p over the points of a pool.
double largest(const ColumnPool& pool, const Eigen::VectorXd& u) {
  double value = -std::numeric_limits<double>::infinity();
  Eigen::VectorXd point(u.size());
  for (std::ptrdiff_t i = 0; i < pool.size(); ++i) {
    pool.copy_point(i, point.data());
    value = std::max(value, u.dot(point));
  }
  return value;
}

class PrimalSimplexOf : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Machine, PrimalSimplexOf, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// ±e_k about the origin and about (3, …, 3): d is the least ‖a‖₁ of A.
TEST_P(PrimalSimplexOf, FindsTheDistanceOfCrossPolytopes) {
  for (const int n : {2, 3, 5, 8, 20}) {
    Eigen::MatrixXd Q(n, 2 * n);
    Q << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd A = Q;
    A.array() += 3;
    Program program(A, Q, kernels());
    ASSERT_EQ(program.solve(), PrimalSimplex::End::solved) << n;
    EXPECT_NEAR(program.simplex.objective(), 3.0 * n - 1, 1e-12 * n) << "‖(3, …, 3)‖₁ less the radius of A";
    EXPECT_EQ(program.simplex.loop().artificials, 0);
    EXPECT_GE(program.simplex.proven_upper(), program.simplex.objective() * (1 - 1e-12));
    EXPECT_LE(program.simplex.proven_upper(), program.simplex.objective() * (1 + 1e-10));
  }
}

// Weak duality holds at any normal, and with equality at the last.
TEST_P(PrimalSimplexOf, EndsWithANormalThatAttainsTheObjective) {
  Random random(4);
  for (const int n : {2, 3, 6, 11, 30}) {
    Eigen::MatrixXd A = sphere_points(n, 8 * n, random);
    A.row(0).array() += 3;
    Program program(A, sphere_points(n, 8 * n, random), kernels());
    ASSERT_EQ(program.solve(), PrimalSimplex::End::solved) << n;
    const Eigen::Map<const Eigen::VectorXd> u(program.simplex.normal(), n);
    EXPECT_NEAR(-largest(program.pool_A, u) / largest(program.pool_Q, -u), program.simplex.objective(),
                1e-10 * program.simplex.objective())
        << n;
  }
}

TEST_P(PrimalSimplexOf, SaysThatAWedgeDoesNotReachWhatIsBehindIt) {
  Eigen::MatrixXd A(2, 3), Q(2, 3);
  A << -2, -3, -3, 0, 1, -1;
  Q << 1, 1, 2, 1, -1, 0;
  Program program(A, Q, kernels());
  ASSERT_EQ(program.solve(), PrimalSimplex::End::unreachable);
  const Eigen::Map<const Eigen::VectorXd> u(program.simplex.normal(), 2);
  EXPECT_LT((u.transpose() * A).maxCoeff(), 0);
  EXPECT_LE((-u.transpose() * Q).maxCoeff(), 1e-12);
}

TEST(PrimalSimplex, StopsAtItsLimitOfPivots) {
  Random random(5);
  Eigen::MatrixXd A = sphere_points(20, 200, random);
  A.row(0).array() += 3;
  Program program(A, sphere_points(20, 200, random), best_kernels(), 7);
  EXPECT_EQ(program.solve(), PrimalSimplex::End::pivot_limit);
  EXPECT_LE(program.simplex.pivots(), 8);
}

}  // namespace
}  // namespace raygauge::test_primal_simplex
