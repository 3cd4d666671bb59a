// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/certify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/baselines/closed_forms.h"

namespace raygauge::testing::test_certify {
namespace {

/// Relative width that certified bounds of well-conditioned data keep, outward rounding included.
constexpr double kCertifiedWidth = 1e-12;

/// The point (3, 1) against the square's vertices: d = 3, attained at q = (1, 1) and (1, -1), u = (-1, 0).
struct PointAgainstSquare {
  GaugeLp lp{instance(points({{3, 1}}), points({{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})), "test"};
  LpAnswer answer{DistanceStatus::optimal, 3, 7, {0, 1, 2}, Eigen::Vector2d(-1, 0)};
};

TEST(CertifiedResult, BoundsMeetAtTheOptimum) {
  const PointAgainstSquare given;
  const DistanceResult result = certified_result(given.lp, given.answer);
  EXPECT_EQ(result.distance, 3);
  EXPECT_LE(result.lower, 3);
  EXPECT_GE(result.upper, 3);
  EXPECT_LE(result.upper - result.lower, kCertifiedWidth * 3);
  EXPECT_EQ(result.counters.pivots, 7);
}

TEST(CertifiedResult, NormalIsScaledToUnitGauge) {
  PointAgainstSquare given;
  given.answer.u = Eigen::Vector2d(-8, 0);
  EXPECT_EQ(certified_result(given.lp, given.answer).normal, Eigen::Vector2d(-1, 0));
}

TEST(CertifiedResult, AWrongObjectiveIsReportedAndContradictedByTheBounds) {
  PointAgainstSquare given;
  given.answer.objective = 0;
  const DistanceResult result = certified_result(given.lp, given.answer);
  EXPECT_EQ(result.distance, 0);
  EXPECT_GT(result.lower, 2.99);
}

TEST(CertifiedResult, WrongDualsAndBasesProveLessButNothingFalse) {
  PointAgainstSquare given;
  for (const Eigen::Vector2d& u :
       {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, -1), Eigen::Vector2d(-1, -1e-3)}) {
    given.answer.u = u;
    EXPECT_LE(certified_result(given.lp, given.answer).lower, 3);
  }
  given.answer.basis = {0, 2, 3};
  EXPECT_EQ(certified_result(given.lp, given.answer).upper, kInf);
}

TEST(CertifiedResult, LeavesBoundsUnsetWhereTheSolverLeftNothing) {
  PointAgainstSquare given;
  const DistanceResult result = certified_result(given.lp, LpAnswer{});
  EXPECT_TRUE(std::isnan(result.distance));
  EXPECT_TRUE(std::isnan(result.lower));
  EXPECT_TRUE(std::isnan(result.upper));
  given.answer.u[0] = std::nan("");
  EXPECT_TRUE(std::isnan(certified_result(given.lp, given.answer).lower));
}

TEST(CertifiedResult, AnUnreachableClaimIsAnInfiniteDistance) {
  PointAgainstSquare given;
  given.answer.status = DistanceStatus::unreachable;
  EXPECT_EQ(certified_result(given.lp, given.answer).distance, kInf);
}

}  // namespace
}  // namespace raygauge::testing::test_certify
