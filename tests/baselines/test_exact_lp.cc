// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_lp.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "baselines/exact_verify.h"
#include "raygauge/exceptions.h"
#include "tests/baselines/closed_forms.h"

namespace raygauge::testing::test_exact_lp {
namespace {

const PointSet& set_A(const Instance& sets) { return dynamic_cast<const PointSet&>(*sets.A); }
const PointSet& set_Q(const Instance& sets) { return dynamic_cast<const PointSet&>(*sets.Q); }

ExactLpResult solve(const Instance& sets) { return solve_exact_lp(set_A(sets), set_Q(sets)); }
bool proves(const Instance& sets, const ExactLpResult& result) {
  return verify(set_A(sets), set_Q(sets), result);
}

std::string expected_status(double distance) {
  return distance == 0 ? "contains_origin" : distance == kInf ? "unreachable" : "optimal";
}

/// n·m points with small integer coordinates: thousands of ties, parallel facets, collinear points.
Matrix lattice(Eigen::Index n, int k, double offset) {
  Eigen::Index count = 1;
  for (Eigen::Index i = 0; i < n; ++i) count *= k + 1;
  Matrix result(n, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::Index rest = i;
    for (Eigen::Index d = 0; d < n; ++d, rest /= k + 1) {
      result(d, i) = static_cast<double>(rest % (k + 1)) + offset;
    }
  }
  return result;
}

Matrix polygon(int m, const Vector& center, double radius) {
  Matrix result(2, m);
  for (int i = 0; i < m; ++i) {
    const double angle = 2 * 3.14159265358979 * i / m;
    result.col(i) = center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return result;
}

Matrix moment_curve(Eigen::Index n, Eigen::Index count, double offset) {
  Matrix result(n, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = -1 + 2 * static_cast<double>(i) / static_cast<double>(count - 1);
    for (Eigen::Index k = 0; k < n; ++k) result(k, i) = std::pow(t, k + 1) + offset;
  }
  return result;
}

TEST(ExactLp, MeetsClosedFormsExactly) {
  std::vector<ClosedForm> forms = well_scaled_forms();
  const std::vector<ClosedForm> small = below_tolerances();
  forms.insert(forms.end(), small.begin(), small.end());
  for (const ClosedForm& form : forms) {
    SCOPED_TRACE(form.name);
    const ExactLpResult result = solve(form.sets);
    EXPECT_EQ(to_string(result.status), expected_status(form.distance));
    EXPECT_EQ(result.rounded.nearest, form.distance);
    EXPECT_TRUE(proves(form.sets, result));
  }
}

TEST(ExactLp, ValueIsTheRationalItself) {
  const ExactLpResult result = solve(instance(3 * Matrix::Identity(9, 9), cube(Vector::Zero(9))));
  EXPECT_EQ(result.value, Rational(1, 3));
  EXPECT_EQ(result.basis.size(), 10u);
}

TEST(ExactLp, TellsOneFromItsNeighbours) {
  const double ulp = std::numeric_limits<double>::epsilon();
  for (const double scale : {1.0, 1 - ulp, 1 + ulp}) {
    const Instance sets = instance(scale * Vector::Unit(4, 2), cube(Vector::Zero(4)));
    EXPECT_EQ(solve(sets).value, Rational(scale));
  }
}

TEST(ExactLp, SolvesLatticesFullOfTies) {
  const Instance sets = instance(lattice(4, 4, 2.5), cube(Vector::Zero(4)));
  const ExactLpResult result = solve(sets);
  EXPECT_EQ(result.value, Rational(5, 2));
  EXPECT_TRUE(proves(sets, result));
}

TEST(ExactLp, DuplicatedPointsChangeNothing) {
  const Instance once = two_spheres(11, 4, 30);
  const Instance often =
      instance(set_A(once).points().replicate(1, 20), set_Q(once).points().replicate(1, 20));
  const ExactLpResult result = solve(often);
  EXPECT_EQ(result.value, solve(once).value);
  EXPECT_TRUE(proves(often, result));
}

TEST(ExactLp, SolvesNearParallelFacetsAndIllConditionedBases) {
  const std::vector<Instance> hard = {
      instance(polygon(500, Eigen::Vector2d(5, 1), 1), polygon(500, Eigen::Vector2d(0, 0), 1)),
      instance(polygon(64, Eigen::Vector2d(1.0000001, 0), 1), polygon(2000, Eigen::Vector2d(0, 0), 1)),
      instance(moment_curve(8, 60, 3), moment_curve(8, 60, 0)),
      instance(1e8 * Vector::Ones(5).replicate(1, 32) + cube(Vector::Zero(5)), cube(Vector::Zero(5))),
  };
  for (const Instance& sets : hard) EXPECT_TRUE(proves(sets, solve(sets)));
}

TEST(ExactLp, ScalingBothSetsByPowersOfTwoChangesNothing) {
  const Instance sets = two_spheres(3, 5, 40);
  const Rational value = solve(sets).value;
  for (const int exponent : {-900, -500, 500, 900}) {
    const double factor = std::ldexp(1.0, exponent);
    const Instance scaled = instance(factor * set_A(sets).points(), factor * set_Q(sets).points());
    const ExactLpResult result = solve(scaled);
    EXPECT_EQ(result.value, value) << exponent;
    EXPECT_TRUE(proves(scaled, result));
  }
}

TEST(ExactLp, SetsOfAnyRankAreValid) {
  Matrix plane(5, 12);
  plane << polygon(12, Vector::Zero(2), 1), Matrix::Zero(3, 12);
  Vector inside = Vector::Zero(5), outside = Vector::Zero(5);
  inside.head(2) << 3, 1;
  outside << 3, 1, 1e-200, 0, 0;
  const Instance reached = instance(inside, plane), missed = instance(outside, plane);
  EXPECT_EQ(to_string(solve(reached).status), "optimal");
  EXPECT_TRUE(proves(reached, solve(reached)));
  EXPECT_EQ(to_string(solve(missed).status), "unreachable");
  EXPECT_TRUE(proves(missed, solve(missed)));
}

TEST(ExactLp, AProvenSuggestionNeedsOnePivotAColumn) {
  const Instance sets = two_spheres(2, 10, 200);
  const ExactLpResult result = solve(sets);
  EXPECT_LE(result.pivots, 2 * 11);
}

TEST(ExactLp, StopsAtATimeLimitWithBoundsThatHold) {
  const Instance sets = two_spheres(1, 6, 100);
  const ExactLpResult result = solve_exact_lp(set_A(sets), set_Q(sets), 0);
  EXPECT_EQ(to_string(result.status), "time_limit");
  EXPECT_EQ(result.rounded.lower, 0);
  EXPECT_EQ(result.rounded.upper, kInf);
  EXPECT_FALSE(proves(sets, result));
}

TEST(ExactLp, ThreadsAgreeWithSerial) {
  std::vector<Rational> serial(6), threaded(6);
  const auto value = [](size_t i) { return solve(two_spheres(i, 4, 80)).value; };
  for (size_t i = 0; i < serial.size(); ++i) serial[i] = value(i);
  const auto share = [&](size_t first) {
    for (size_t i = first; i < threaded.size(); i += 2) threaded[i] = value(i);
  };
  std::thread one(share, 0), two(share, 1);
  one.join();
  two.join();
  EXPECT_EQ(serial, threaded);
}

TEST(ExactLp, RefusesSetsOfDifferentDimension) {
  EXPECT_THROW(solve_exact_lp(PointSet(points({{1, 2}})), PointSet(points({{1}}))), DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::testing::test_exact_lp
