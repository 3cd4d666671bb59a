// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/certify.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <random>

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

// Points that have no feasible combination, as at the end of a solve that found none: to prove so much
// exactly takes hours at this size, in which a sweep once stood still.
TEST(CertifiedResult, DoesNotProveAtAnyPriceWhatTheSolverLeft) {
  const int n = 200;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto cloud = [&](double offset) {
    Eigen::MatrixXd result = Eigen::MatrixXd::NullaryExpr(n, 300, [&] { return normal(random); });
    result.colwise().normalize();
    result.row(0).array() += offset;
    return std::make_shared<PointSet>(result);
  };
  const GaugeLp lp(Instance{cloud(3), cloud(0), {}}, "test");
  LpAnswer answer;
  for (std::ptrdiff_t i = 0; i <= n; ++i) answer.basis.push_back(i % 2 == 0 ? i : 300 + i);
  const auto begin = std::chrono::steady_clock::now();
  const DistanceResult result = certified_result(lp, answer);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(result.upper, kInf);
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
