// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Degenerate optima of points that a shear has left without digits: instances that took thousands of basis
// changes, the last of them in twice the precision, are proven from the columns that carry weight.
#include <gtest/gtest.h>

#include "raygauge/queries/solver.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_sheared_optima {
namespace {

struct Case {
  std::string generator;
  int n, N, repetition;
  std::int64_t most_pivots;
};

DistanceResult solved(const Case& tested, const Instance& instance) {
  DistanceOptions options;
  options.tolerance = 1e-6;
  options.method = DistanceMethod::column_generation;
  DistanceSolver solver(options);
  DistanceResult result = solver.solve(*instance.A, *instance.Q);
  EXPECT_LE(result.counters.pivots, tested.most_pivots) << tested.generator << " " << tested.repetition;
  EXPECT_EQ(result.counters.exact_pivots, 0);
  return result;
}

const Parameters kSheared = {{"ties", 0.05}, {"entry", std::int64_t{1000}}};

TEST(ShearedOptima, TheOriginOnAFaceIsProvenByTheFace) {
  for (const Case& tested :
       {Case{"hard_planted_origin", 50, 100, 16, 300}, Case{"hard_planted_origin", 50, 100, 25, 400},
        Case{"hard_planted_origin", 100, 200, 24, 550}, Case{"hard_planted_origin", 100, 200, 30, 900}}) {
    const Instance instance =
        generate(tested.generator, {1, tested.n, tested.N, tested.repetition}, kSheared);
    const DistanceResult result = solved(tested, instance);
    EXPECT_EQ(result.status, DistanceStatus::contains_origin);
    double sum = 0;
    for (const PointWeight& weight : result.origin_weights) sum += weight.weight;
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_EQ(result.origin_weights.size(), static_cast<std::size_t>(tested.N / 20));
  }
}

TEST(ShearedOptima, TiesAreProvenByTheInteriorPointMethodOfWhitenedPoints) {
  for (const Case& tested : {Case{"hard_planted_unimodular", 200, 202, 21, 1500},
                             Case{"hard_planted_unimodular", 200, 202, 28, 1500}}) {
    const Instance instance =
        generate(tested.generator, {1, tested.n, tested.N, tested.repetition}, kSheared);
    const DistanceResult result = solved(tested, instance);
    EXPECT_EQ(result.status, DistanceStatus::optimal);
    EXPECT_LE(result.lower, 3);
    EXPECT_GE(result.upper, 3);
  }
}

}  // namespace
}  // namespace raygauge::test_sheared_optima
