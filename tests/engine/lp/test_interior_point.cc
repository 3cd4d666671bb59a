// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
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
    ASSERT_EQ(method.solve(problem.pool_A.view(), problem.pool_Q.view(), n, problem.guess.data(),
                           best_kernels(), stopwatch),
              InteriorPoint::End::converged)
        << "n = " << n;
    EXPECT_LE(method.iterations(), 30);
    std::vector<std::int64_t> ids;
    method.columns(ids);
    PrimalSimplex program;
    program.begin(n, 0, 0, best_kernels());
    ASSERT_TRUE(program.start_from(problem.pool_A, problem.pool_Q, ids, stopwatch)) << "n = " << n;
    EXPECT_EQ(program.solve(problem.pool_A, problem.pool_Q, stopwatch), PrimalSimplex::End::solved);
    EXPECT_LE(program.pivots(), 1);
    DistanceSolver solver;
    EXPECT_NEAR(program.objective(), solver.solve(problem.A, problem.Q).distance, 1e-6 * program.objective());
  }
}

// A basis with a few wrong columns, as near ties leave it, has negative weights.
TEST(InteriorPoint, AWrongColumnOrThreeOfItsBasisAreExchanged) {
  const int n = 40;
  Problem problem(n, 6 * n, 7);
  const Stopwatch stopwatch;
  InteriorPoint method;
  ASSERT_EQ(method.solve(problem.pool_A.view(), problem.pool_Q.view(), n, problem.guess.data(),
                         best_kernels(), stopwatch),
            InteriorPoint::End::converged);
  std::vector<std::int64_t> ids;
  method.columns(ids);
  double distance = 0;
  int negative = 0;
  for (int wrong = 0; wrong <= 3; ++wrong) {
    std::vector<std::int64_t> columns = ids;
    std::int64_t candidate = 1;  // points of Q that are not basic
    for (int i = 0; i < wrong; ++i) {
      while (std::find(columns.begin(), columns.end(), candidate) != columns.end()) candidate += 2;
      columns[static_cast<std::size_t>(n - i)] = candidate;
    }
    PrimalSimplex program;
    program.begin(n, 0, 0, best_kernels());
    ASSERT_TRUE(program.start_from(problem.pool_A, problem.pool_Q, columns, stopwatch)) << wrong;
    negative += program.pivots() > 0 ? 1 : 0;
    EXPECT_EQ(program.solve(problem.pool_A, problem.pool_Q, stopwatch), PrimalSimplex::End::solved);
    EXPECT_LE(program.pivots(), 60) << wrong;
    if (wrong == 0) distance = program.objective();
    EXPECT_NEAR(program.objective(), distance, 1e-10 * distance) << wrong;
  }
  EXPECT_GT(negative, 0);
}

TEST(InteriorPoint, AndItsBasisAreTheSameBitForBitOnAnyNumberOfThreads) {
  for (const auto& [n, N] : {std::pair{150, 1600}, std::pair{260, 900}}) {
    Problem problem(n, N, 3);
    DistanceOptions options;
    DistanceSolver alone(options);
    const DistanceResult expected = alone.solve(problem.A, problem.Q, Effects::witness);
    for (const int threads : {2, 3}) {
      options.threads = threads;
      DistanceSolver solver(options);
      const DistanceResult& result = solver.solve(problem.A, problem.Q, Effects::witness);
      EXPECT_EQ(result.lower, expected.lower) << n;
      EXPECT_EQ(result.upper, expected.upper) << n;
      EXPECT_EQ(result.normal, expected.normal) << n;
      EXPECT_EQ(result.contact_point, expected.contact_point) << n;
    }
  }
}

TEST(InteriorPoint, SeparatesWhatNoMultipleReaches) {
  for (const int n : {10, 40}) {
    Problem problem(n, n + 2, static_cast<unsigned>(n));
    const Stopwatch stopwatch;
    InteriorPoint method;
    ASSERT_EQ(method.solve(problem.pool_A.view(), problem.pool_Q.view(), n, problem.guess.data(),
                           best_kernels(), stopwatch),
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

// Sets of n + 2 points, away along an axis: the interior-point method asked for a margin that they did not
// leave, and the simplex began anew, with up to 15 158 basis changes at n = 500.
TEST(InteriorPoint, SeparatesByMarginsFarBelowTheSizeOfTheNormal) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Random random(800 + seed);
    const Eigen::MatrixXd q = sphere_points(260, 262, random);
    Eigen::MatrixXd a = sphere_points(260, 262, random);
    a.row(0).array() += 3;
    DistanceSolver solver;
    const DistanceResult& result = solver.solve(PointSet(a), PointSet(q));
    EXPECT_EQ(result.status, DistanceStatus::unreachable) << "seed " << seed;
    EXPECT_EQ(result.counters.pivots, 0) << "seed " << seed;
    EXPECT_GT((result.normal.transpose() * q).minCoeff(), 0) << "seed " << seed;
    EXPECT_LT((result.normal.transpose() * a).maxCoeff(), 0) << "seed " << seed;
  }
}

// The points in blocks of 16, single precision.
AlignedBuffer<float> single_blocks(const Eigen::MatrixXd& points) {
  const Eigen::Index n = points.rows(), pairs = (points.cols() + 15) / 16;
  AlignedBuffer<float> blocks;
  blocks.reserve(static_cast<std::size_t>(16 * n * pairs));
  for (Eigen::Index i = 0; i < 16 * pairs; ++i) {
    for (Eigen::Index k = 0; k < n; ++k)
      blocks[static_cast<std::size_t>((i / 16 * n + k) * 16 + i % 16)] =
          static_cast<float>(points(k, std::min(i, points.cols() - 1)));
  }
  return blocks;
}

TEST(AddWeighted, AndProductsAreThoseOfTheMatrixOfPointsOnEveryInstructionSet) {
  for (const InstructionSet isa : instruction_sets_here()) {
    const Kernels& kernels = kernels_for(isa);
    for (const int n : {1, 5, 37}) {
      for (const int N : {8, 40, 296}) {  // whole blocks: none, or groups of four and some left
        Random random(static_cast<unsigned>(n));
        const Eigen::MatrixXd points = gaussian_points(n, N, random).cast<float>().cast<double>();
        const PointSet S(points);
        const AlignedBuffer<float> single = single_blocks(points);
        const std::ptrdiff_t pairs = (N + 15) / 16;
        AlignedBuffer<double> weight, values, scratch;
        weight.reserve(static_cast<std::size_t>(16 * pairs));
        values.reserve(static_cast<std::size_t>(16 * pairs));
        scratch.reserve(8 * static_cast<std::size_t>(n));
        std::fill_n(weight.data(), 16 * pairs, 0.0);
        Eigen::Map<Eigen::VectorXd> w(weight.data(), N);
        w = gaussian_points(N, 1, random).col(0);
        const Eigen::VectorXd u = gaussian_points(n, 1, random).col(0), ones = Eigen::VectorXd::Ones(n);
        const Eigen::Map<const Eigen::VectorXd> found(values.data(), N);
        for (const bool in_single : {false, true}) {
          SCOPED_TRACE(::testing::Message() << n << ' ' << N << (in_single ? " single" : " double"));
          Eigen::VectorXd sum = ones;
          if (in_single) {
            kernels.add_weighted_single(single.data(), pairs, n, w.data(), scratch.data(), sum.data());
            kernels.products_single(single.data(), pairs, n, u.data(), values.data());
          } else {
            kernels.add_weighted(S.data(), S.block_count(), n, w.data(), scratch.data(), sum.data());
            kernels.products(S.data(), S.block_count(), n, u.data(), values.data());
          }
          EXPECT_LT((sum - ones - points * w).cwiseAbs().maxCoeff(), 1e-11);
          EXPECT_LT((found - points.transpose() * u).cwiseAbs().maxCoeff(), 1e-12 * n);
        }
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_interior_point
