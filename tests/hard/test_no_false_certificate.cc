// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What a solver of this library says of a hard instance is never wrong: the bounds hold, and a status that
// claims an answer has one. And it is complete: in the dimensions below, every instance is certified to a
// relative width of 1e-12.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raygauge/queries/solver.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_no_false_certificate {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_certified(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
}

class NoFalseCertificate : public testing::TestWithParam<HardCase> {};

void expect_bounds_hold(const DistanceResult& result, double exact_distance, bool rounded) {
  const double above = rounded ? std::nextafter(exact_distance, kInfinity) : exact_distance;
  const double below = rounded ? std::nextafter(exact_distance, 0) : exact_distance;
  EXPECT_LE(result.lower, above);
  EXPECT_GE(result.upper, below);
}

void expect_status_is_true(const DistanceResult& result, double exact_distance) {
  switch (result.status) {
    case DistanceStatus::optimal:
      EXPECT_LE(result.upper - result.lower, kTolerance * result.upper);
      EXPECT_LE(result.lower, result.distance);
      EXPECT_LE(result.distance, result.upper);
      break;
    case DistanceStatus::contains_origin:
      EXPECT_EQ(exact_distance, 0);
      EXPECT_EQ(result.distance, 0);
      break;
    case DistanceStatus::unreachable:
      EXPECT_EQ(exact_distance, kInfinity);
      EXPECT_EQ(result.distance, kInfinity);
      break;
    default:  // a limit: the bounds are all that is claimed
      break;
  }
}

void solve_everything(const HardCase& tested, DistanceMethod method) {
  constexpr int kPoints = 100, kRepetitions = 3, kLargestDimension = 50;
  DistanceOptions options;
  options.method = method;
  options.tolerance = kTolerance;
  DistanceSolver solver;
  for (const int n : dimensions_of(tested, kLargestDimension)) {
    options.time_limit = n > tested.certified_n ? 1 : kInfinity;
    solver.set_options(options);
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      const Instance instance = generate(tested.generator, {3, n, kPoints, repetition}, tested.parameters);
      ASSERT_TRUE(instance.exact_distance.has_value());
      const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
      SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition) + ", status " +
                   std::string(to_string(result.status)));
      expect_bounds_hold(result, *instance.exact_distance, tested.rounded);
      expect_status_is_true(result, *instance.exact_distance);
      EXPECT_TRUE(n > tested.certified_n || is_certified(result.status));
    }
  }
}

TEST_P(NoFalseCertificate, ComesFromColumnGeneration) {
  solve_everything(GetParam(), DistanceMethod::column_generation);
}

TEST_P(NoFalseCertificate, ComesFromZhengYamane) {
  solve_everything(GetParam(), DistanceMethod::zheng_yamane);
}

INSTANTIATE_TEST_SUITE_P(Families, NoFalseCertificate, testing::ValuesIn(hard_cases()),
                         [](const auto& test) { return label(test.param); });

}  // namespace
}  // namespace raygauge::test_no_false_certificate
