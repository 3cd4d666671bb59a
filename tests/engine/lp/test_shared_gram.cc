// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/shared_gram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_shared_gram {
namespace {

using LowerMap = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

PricedPoints view_of(const PointSet& S) { return {S.data(), S.block_count(), nullptr, 0, S.size()}; }

struct Weighted {
  std::shared_ptr<const PointSet> S;
  std::vector<double> weight;  // of lanes
  Eigen::MatrixXd gram;
};

// Some weights are zero: blocks with one point, with all and with none.
Weighted weighted_points(int n, int N, unsigned seed) {
  Random random(seed);
  const Eigen::MatrixXd points = gaussian_points(n, N, random);
  Vector weight = gaussian_points(N, 1, random).col(0).cwiseAbs();
  for (int i = 0; i < N; ++i) {
    if (i % 40 > 20 && i % 40 != 30) weight[i] = 0;
  }
  auto S = std::make_shared<const PointSet>(points);
  std::vector<double> lanes(static_cast<std::size_t>(S->block_count()) * PointSet::kLanes, 0.0);
  std::copy_n(weight.data(), N, lanes.data());
  return {std::move(S), std::move(lanes), points * weight.asDiagonal() * points.transpose()};
}

LowerMap matrix_of(const SharedGram& gram, int n) {
  return {gram.data(), n, n, Eigen::OuterStride<>(gram.rows())};
}

double lower_error(const LowerMap& M, const Eigen::MatrixXd& expected) {
  const Eigen::MatrixXd difference = M - expected;
  return Eigen::MatrixXd(difference.triangularView<Eigen::Lower>()).cwiseAbs().maxCoeff();
}

TEST(SharedGram, IsTheWeightedSumOfOuterProductsOnEveryInstructionSet) {
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const int n : {1, 5, 16, 17, 37, 96, 130}) {
      const Weighted points = weighted_points(n, 300, static_cast<unsigned>(n));
      for (const bool single : {false, true}) {
        SharedGram gram;
        gram.begin(n, kernels_for(isa), {});
        gram.add(view_of(*points.S), points.weight.data(), single);
        EXPECT_LT(lower_error(matrix_of(gram, n), points.gram), 300 * (single ? 1e-5 : 1e-12))
            << "n = " << n << ", single " << single;
      }
    }
  }
}

// Below, at and beyond the 48 columns that are factored at a time.
TEST(SharedGram, FactorsPositiveDefiniteMatricesAndNoOthersOnEveryInstructionSet) {
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const int n : {1, 5, 32, 47, 48, 49, 64, 97, 150}) {
      const Weighted points = weighted_points(n, 2 * n + 300, static_cast<unsigned>(n));
      SharedGram gram;
      gram.begin(n, kernels_for(isa), {});
      gram.add(view_of(*points.S), points.weight.data(), false);
      ASSERT_TRUE(gram.factor()) << n;
      const Eigen::MatrixXd L = matrix_of(gram, n).triangularView<Eigen::Lower>();
      EXPECT_LT((L * L.transpose() - points.gram).cwiseAbs().maxCoeff(), 1e-12 * n * points.gram.maxCoeff())
          << n;

      gram.begin(n, kernels_for(isa), {});
      gram.add(view_of(*points.S), points.weight.data(), false);
      gram.data()[static_cast<std::ptrdiff_t>(n - 1) * gram.rows() + n - 1] = -1;
      EXPECT_FALSE(gram.factor()) << n;
    }
  }
}

TEST(SharedGram, IsTheSameBitForBitOnAnyNumberOfThreads) {
  const int n = 300;
  const Weighted points = weighted_points(n, 1000, 5);
  const auto size = static_cast<std::ptrdiff_t>(gram_rows(n)) * n;
  std::vector<double> alone;
  for (const int threads : {1, 2, 3}) {
    for (const bool single : {true, false}) {
      ChunkTeam team;
      team.be_patient();
      SharedGram gram;
      gram.begin(n, best_kernels(), {team, threads});
      gram.add(view_of(*points.S), points.weight.data(), single);
      gram.add(view_of(*points.S), points.weight.data(), false);
      ASSERT_TRUE(gram.factor());
      const std::vector<double> found(gram.data(), gram.data() + size);
      if (single && threads == 1) alone = found;
      if (single) {
        EXPECT_EQ(found, alone) << threads << " threads";
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_shared_gram
