// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The smooth hard families: whatever a method ends in, its bounds hold and its status is true. How far each
// family is certified is part of its case (smooth_hard_cases); beyond, `precision_limit` is the honest end.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/distance/solver.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_smooth_cases {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_answered(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin;
}

void expect_truth(const DistanceResult& result, const HardCase& tested, double exact, double tolerance) {
  EXPECT_LE(result.lower, tested.rounded ? std::nextafter(exact, kInfinity) : exact);
  EXPECT_GE(result.upper, tested.rounded ? std::nextafter(exact, 0) : exact);
  EXPECT_EQ(result.status == DistanceStatus::contains_origin, exact == 0 && is_answered(result.status));
  EXPECT_TRUE(result.status != DistanceStatus::unreachable || exact == kInfinity);
  if (result.status == DistanceStatus::optimal) {
    EXPECT_LE(result.upper - result.lower, tolerance * result.upper);
  }
}

class SmoothCases : public testing::TestWithParam<HardCase> {
 protected:
  /// Solves to `tolerance` in the dimensions up to `limit`; up to `answered_n` there must be an answer.
  static void solve_everything(double tolerance, int limit, int answered_n) {
    const HardCase& tested = GetParam();
    DistanceOptions options;
    options.tolerance = tolerance;
    for (const auto method : {DistanceMethod::direct, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
      options.method = method;
      DistanceSolver solver(options);
      for (const int n : dimensions_of(tested, limit)) {
        for (int repetition = 0; repetition < (n > 5 ? 1 : 2); ++repetition) {
          const Instance instance = generate(tested.generator, {3, n, 1, repetition}, tested.parameters);
          const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
          SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition) + ", " +
                       std::string(to_string(method)) + ": " + std::string(to_string(result.status)));
          expect_truth(result, tested, instance.exact_distance.value(), tolerance);
          EXPECT_TRUE(n > answered_n || is_answered(result.status));
        }
      }
    }
  }
};

TEST_P(SmoothCases, AreNeverFalseAndCertifiedToTwelveDigits) {
  solve_everything(1e-12, 8, GetParam().certified_n);
}

TEST_P(SmoothCases, AreCertifiedToSixDigits) { solve_everything(1e-6, 8, GetParam().answered_n); }

INSTANTIATE_TEST_SUITE_P(Families, SmoothCases, testing::ValuesIn(smooth_hard_cases()),
                         [](const auto& test) { return label(test.param); });

// Beyond ε = 0 no multiple of the disc meets A; at it, the union of all multiples is an open half-plane with
// A on its boundary, and no direction proves what is true.
TEST(TangentDisc, OutOfReachHasBoundsWithoutAnEnd) {
  for (const auto method : {DistanceMethod::direct, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
    DistanceOptions options;
    options.method = method;
    DistanceSolver solver(options);
    const Instance instance = generate("hard_tangent_disc", {1, 2, 1, 0}, {{"epsilon", 0.0}});
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    EXPECT_EQ(result.status, DistanceStatus::precision_limit);
    EXPECT_EQ(result.upper, kInfinity);
    EXPECT_GT(result.lower, 1e3);
  }
}

}  // namespace
}  // namespace raygauge::test_smooth_cases
