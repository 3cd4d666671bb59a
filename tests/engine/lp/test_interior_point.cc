// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_point.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/lp/primal_simplex.h"
#include "engine/numerics/aligned_buffer.h"
#include "raygauge/queries/solver.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_interior_point {
namespace {

struct Problem {
  PointSet A;
  PointSet Q;
  ColumnPool pool_A;
  ColumnPool pool_Q;
  Vector guess;

  Problem(int n, int N, unsigned seed) : A(random_A(n, N, seed)), Q(random_Q(n, N, seed)), guess(n) {
    const Vector ones = Vector::Ones(n);
    pool_A.choose(A, ones.data(), true, true);
    pool_Q.choose(Q, ones.data(), true, true);
    guess.setZero();
    guess[0] = -1;
  }
  static Eigen::MatrixXd random_A(int n, int N, unsigned seed) {
    Random random(seed);
    Eigen::MatrixXd a = sphere_points(n, N, random);
    a.row(0).array() += 3;
    return a;
  }
  static Eigen::MatrixXd random_Q(int n, int N, unsigned seed) {
    Random random(seed + 1000);
    return sphere_points(n, N, random);
  }
};

TEST(InteriorPoint, EndsAtTheOptimalBasisOfASetInGeneralPosition) {
  for (const int n : {3, 10, 40, 90}) {
    Problem problem(n, 6 * n, static_cast<unsigned>(n));
    const Stopwatch stopwatch;
    InteriorPoint method;
    ASSERT_EQ(
        method.solve(problem.pool_A, problem.pool_Q, n, problem.guess.data(), best_kernels(), stopwatch),
        InteriorPoint::End::converged)
        << "n = " << n;
    EXPECT_LE(method.iterations(), 30);
    std::vector<std::int64_t> ids;
    method.columns(ids);
    PrimalSimplex program;
    program.begin(n, 0, 0, best_kernels());
    ASSERT_TRUE(program.start_from(problem.pool_A, problem.pool_Q, ids)) << "n = " << n;
    EXPECT_EQ(program.solve(problem.pool_A, problem.pool_Q, stopwatch), PrimalSimplex::End::solved);
    EXPECT_LE(program.pivots(), 1);
    DistanceSolver solver;
    EXPECT_NEAR(program.objective(), solver.solve(problem.A, problem.Q).distance, 1e-6 * program.objective());
  }
}

TEST(InteriorPoint, SeparatesWhatNoMultipleReaches) {
  for (const int n : {10, 40}) {
    Problem problem(n, n + 2, static_cast<unsigned>(n));
    const Stopwatch stopwatch;
    InteriorPoint method;
    ASSERT_EQ(
        method.solve(problem.pool_A, problem.pool_Q, n, problem.guess.data(), best_kernels(), stopwatch),
        InteriorPoint::End::separated);
    const Eigen::Map<const Eigen::VectorXd> u(method.normal(), n);
    EXPECT_LT((u.transpose() * Problem::random_A(n, n + 2, static_cast<unsigned>(n))).maxCoeff(), 0);
    EXPECT_GT((u.transpose() * Problem::random_Q(n, n + 2, static_cast<unsigned>(n))).minCoeff(), 0);
  }
}

TEST(InteriorPoint, StartsTheSimplexInManyDimensions) {
  Problem problem(450, 1400, 7);
  DistanceSolver solver;
  const DistanceResult& result = solver.solve(problem.A, problem.Q);
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.counters.pivots, 20) << "the simplex alone takes thousands";
}

TEST(InteriorPoint, ProvesUnreachableInManyDimensions) {
  Problem problem(450, 500, 8);
  DistanceSolver solver;
  const DistanceResult& result = solver.solve(problem.A, problem.Q);
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
  EXPECT_EQ(result.counters.pivots, 0);
  EXPECT_EQ(result.counters.exact_pivots, 0);
}

TEST(AddGram, IsTheWeightedSumOfOuterProductsOnEveryInstructionSet) {
  for (const InstructionSet isa : instruction_sets_here()) {
    const Kernels& kernels = kernels_for(isa);
    for (const int n : {1, 5, 16, 17, 37, 96}) {
      const int N = 300;
      Random random(static_cast<unsigned>(n));
      const Eigen::MatrixXd points = gaussian_points(n, N, random);
      const PointSet S(points);
      Vector weight = gaussian_points(N, 1, random).col(0).cwiseAbs();
      weight[5] = 0;
      AlignedBuffer<double> lanes;
      AlignedBuffer<double> scratch;
      AlignedBuffer<double> M;
      lanes.reserve(static_cast<std::size_t>(S.block_count()) * PointSet::kLanes);
      scratch.reserve(static_cast<std::size_t>(gram_rows(n) + gram_columns(n)) * kGramPoints);
      const int ld = gram_rows(n);
      const auto size = static_cast<std::size_t>(ld) * static_cast<std::size_t>(gram_columns(n));
      M.reserve(size);
      std::fill_n(M.data(), size, 0.0);
      std::fill_n(lanes.data(), lanes.capacity(), 0.0);
      std::copy_n(weight.data(), N, lanes.data());
      kernels.add_gram(S.data(), S.block_count(), n, lanes.data(), scratch.data(), M.data());
      const Eigen::MatrixXd expected = points * weight.asDiagonal() * points.transpose();
      for (int j = 0; j < n; ++j) {
        for (int i = j; i < n; ++i) {
          EXPECT_NEAR(
              M[static_cast<std::size_t>(j) * static_cast<std::size_t>(ld) + static_cast<std::size_t>(i)],
              expected(i, j), 1e-12 * N)
              << "n = " << n << ", entry " << i << ", " << j;
        }
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_interior_point
