// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The exact rational linear program against what the hard families say of themselves and, where they are
// silent, against the bounds that both methods of the engine certify.
#include <gtest/gtest.h>

#include <cmath>

#include "baselines/exact_lp.h"
#include "baselines/exact_verify.h"
#include "raygauge/queries/solver.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_exact_truth {
namespace {

constexpr int kPoints = 40;
constexpr int kRepetitions = 2;

ExactLpResult verified_truth(const Instance& instance) {
  const auto& A = dynamic_cast<const PointSet&>(*instance.A);
  const auto& Q = dynamic_cast<const PointSet&>(*instance.Q);
  ExactLpResult truth = solve_exact_lp(A, Q);
  EXPECT_TRUE(verify(A, Q, truth));
  return truth;
}

class KnownDistance : public testing::TestWithParam<HardCase> {};

TEST_P(KnownDistance, IsProvenByTheExactLinearProgram) {
  constexpr int kLargestDimension = 50;
  const HardCase& tested = GetParam();
  for (const int n : dimensions_of(tested, kLargestDimension)) {
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition));
      const Instance instance = generate(tested.generator, {2, n, kPoints, repetition}, tested.parameters);
      const ExactLpResult truth = verified_truth(instance);
      ASSERT_TRUE(instance.exact_distance.has_value());
      EXPECT_EQ(truth.rounded.nearest, *instance.exact_distance);
      if (std::isfinite(*instance.exact_distance) && !tested.rounded) {
        EXPECT_EQ(truth.value, Rational(*instance.exact_distance));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, KnownDistance, testing::ValuesIn(hard_cases()),
                         [](const auto& test) { return label(test.param); });

class UnknownDistance : public testing::TestWithParam<HardCase> {};

TEST_P(UnknownDistance, LiesWithinTheBoundsOfBothMethods) {
  constexpr int kLargestDimension = 8;
  const HardCase& tested = GetParam();
  for (const int n : dimensions_of(tested, kLargestDimension)) {
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      const Instance instance = generate(tested.generator, {2, n, kPoints, repetition}, tested.parameters);
      const ExactLpResult truth = verified_truth(instance);
      EXPECT_NE(truth.status, DistanceStatus::unreachable) << "Q is meant to surround the origin";
      for (const auto method : {DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
        DistanceOptions options;
        options.method = method;
        DistanceSolver solver(options);
        const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
        SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition) + ", " +
                     std::string(to_string(method)) + ": " + std::string(to_string(result.status)));
        EXPECT_LE(result.lower, truth.rounded.upper);
        EXPECT_GE(result.upper, truth.rounded.lower);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, UnknownDistance, testing::ValuesIn(hard_cases_of_unknown_distance()),
                         [](const auto& test) { return label(test.param); });

}  // namespace
}  // namespace raygauge::test_exact_truth
