// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The smooth hard families: whatever a method ends in, its bounds hold and its status is true. How far each
// family is certified is part of its case (smooth_hard_cases).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_smooth_cases {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_answered(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
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
  /// Solves to `tolerance` in the dimensions up to 20.
  static void solve_everything(double tolerance) {
    const HardCase& tested = GetParam();
    DistanceOptions options;
    options.tolerance = tolerance;
    for (const auto method :
         {DistanceMethod::column_generation, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
      options.method = method;
      DistanceSolver solver(options);
      for (const int n : dimensions_of(tested, 20)) {
        for (int repetition = 0; repetition < (n > 5 ? 1 : 2); ++repetition) {
          const Instance instance = generate(tested.generator, {3, n, 1, repetition}, tested.parameters);
          const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
          SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition) + ", " +
                       std::string(to_string(method)) + ": " + std::string(to_string(result.status)));
          expect_truth(result, tested, instance.exact_distance.value(), tolerance);
          EXPECT_TRUE(n > tested.certified_n || is_answered(result.status));
        }
      }
    }
  }
};

TEST_P(SmoothCases, AreNeverFalseAndCertifiedToTwelveDigits) { solve_everything(1e-12); }

TEST_P(SmoothCases, AreCertifiedToSixDigits) { solve_everything(1e-6); }

INSTANTIATE_TEST_SUITE_P(Families, SmoothCases, testing::ValuesIn(smooth_hard_cases()),
                         [](const auto& test) { return label(test.param); });

void expect_out_of_reach(const ConvexSet& A, const ConvexSet& Q) {
  for (const auto method :
       {DistanceMethod::column_generation, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
    DistanceOptions options;
    options.method = method;
    DistanceSolver solver(options);
    const DistanceResult& result = solver.solve(A, Q);
    EXPECT_EQ(result.status, DistanceStatus::unreachable);
    EXPECT_EQ(result.lower, kInfinity);
    EXPECT_LE(A.support_function(result.normal), 0);
  }
}

// At ε = 0 the union of all multiples of the disc is an open half-space with A on its boundary: no Farkas
// direction separates them strictly.
TEST(TangentDisc, OutOfReachIsProvenWhereItTouchesTheOrigin) {
  for (const int n : {2, 3, 8}) {
    const Instance instance = generate("hard_tangent_disc", {1, n, 1, 0}, {{"epsilon", 0.0}});
    expect_out_of_reach(*instance.A, *instance.Q);
  }
  const PointSet segment(Eigen::MatrixXd{{0, -1}, {2, 3}});  // one end in the tangent, one behind it
  expect_out_of_reach(segment, Ball(Vector{{1, 0}}, 1));
}

// One end of A in the tangent, the other in reach: nothing is to be concluded from the former.
TEST(TangentDisc, IsReachedByTheRestOfA) {
  const PointSet segment(Eigen::MatrixXd{{0, 1}, {1, 1}});
  const DistanceResult result = DistanceSolver().solve(segment, Ball(Vector{{1, 0}}, 1));
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, 1);
  EXPECT_GE(result.upper, 1);
}

}  // namespace
}  // namespace raygauge::test_smooth_cases
