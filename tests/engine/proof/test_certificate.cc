// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/proof/certificate.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <string>

#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_certificate {
namespace {

using Limits = std::numeric_limits<double>;

class SupportValueOnEveryKernel : public ::testing::TestWithParam<InstructionSet> {
 protected:
  // |h_S(u) - value| <= error in exact arithmetic. Returns the claimed value.
  SupportValue check(const Eigen::MatrixXd& points, const Vector& u) const {
    const PointSet S(points);
    const SupportValue h = support_value(kernels_for(GetParam()), S, u.data());
    EXPECT_FALSE(std::isnan(h.value)) << "u = " << u.transpose();
    EXPECT_FALSE(std::isnan(h.error)) << "u = " << u.transpose();
    if (!std::isfinite(h.value) || !std::isfinite(h.error)) return h;
    const Rational off = abs(exact_support(points, u) - Rational(h.value));
    EXPECT_LE(off, Rational(h.error))
        << "off by " << off.convert_to<double>() << ", claimed " << h.error << "\nu = " << u.transpose();
    return h;
  }
};

INSTANTIATE_TEST_SUITE_P(Machine, SupportValueOnEveryKernel, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

TEST_P(SupportValueOnEveryKernel, HoldsOnRandomSetsAtEveryScale) {
  Random random(41);
  for (const int exponent : {0, -500, 500, -30, 30}) {
    for (const int n : {1, 2, 3, 5, 10, 17}) {
      for (const int N : {1, 9, 40}) {
        const double scale = std::ldexp(1.0, exponent);
        check(scale * gaussian_points(n, N, random), gaussian_points(n, 1, random));
        check(scale * gaussian_points(n, N, random), gaussian_points(n, 1, random) / scale);
      }
    }
  }
}

TEST_P(SupportValueOnEveryKernel, HoldsInTwiceThePrecisionOfADirection) {
  Random random(43);
  for (const int n : {2, 5, 17, 60}) {
    const Eigen::MatrixXd points = gaussian_points(n, 90, random);
    // A direction in which n points are level up to rounding, as at the end of a solve.
    const Eigen::MatrixXd level = points.leftCols(n).transpose();
    const Vector u = level.fullPivLu().solve(-Vector::Ones(n));
    const Vector u_low = 0x1p-54 * u.cwiseProduct(gaussian_points(n, 1, random));
    std::ptrdiff_t index = -1;
    const PointSet S(points);
    const SupportValue h = support_value_twofold(kernels_for(GetParam()), S, u.data(), u_low.data(), &index);
    Rational best = exact_dot(points.col(0), u) + exact_dot(points.col(0), u_low);
    for (Eigen::Index i = 1; i < points.cols(); ++i) {
      const Rational value = exact_dot(points.col(i), u) + exact_dot(points.col(i), u_low);
      if (value > best) best = value;
    }
    EXPECT_LE(abs(best - Rational(h.value)), Rational(h.error)) << "n = " << n;
    EXPECT_LE(h.error, 1e-15 * std::fabs(h.value)) << "n = " << n;
    const Rational attained = exact_dot(points.col(index), u) + exact_dot(points.col(index), u_low);
    EXPECT_LE(abs(best - attained).convert_to<double>(), 1e-15 * std::fabs(h.value)) << "n = " << n;
  }
}

TEST_P(SupportValueOnEveryKernel, HoldsInTheRangeOfSubnormalNumbers) {
  Random random(42);
  for (const int exponent : {-520, -530, -537, -540, -550}) {
    for (int trial = 0; trial < 20; ++trial) {
      const double scale = std::ldexp(1.0, exponent);
      check(scale * gaussian_points(4, 20, random), scale * gaussian_points(4, 1, random));
    }
  }
}

TEST_P(SupportValueOnEveryKernel, ResolvesWhatCancels) {
  // u is orthogonal to every point up to the rounding of its coordinates.
  Random random(43);
  for (int trial = 0; trial < 50; ++trial) {
    const int n = 2 + trial % 6;
    const Vector u = gaussian_points(n, 1, random);
    Eigen::MatrixXd points = gaussian_points(n, 30, random);
    for (int i = 0; i < 30; ++i) points.col(i) -= points.col(i).dot(u) / u.squaredNorm() * u;
    const SupportValue h = check(points, u);
    EXPECT_LE(h.error, 1e-14 * std::fabs(h.value) + 1e-28);
  }
}

TEST_P(SupportValueOnEveryKernel, KnowsAnExactZero) {
  // Points of the plane x_1 + x_2 + x_3 = 0, and one behind it.
  Eigen::MatrixXd points(3, 4);
  points << 0.1, -0.7, 1e10, -1, -0.1, 0, -1e10, -2, 0, 0.7, 0, -3;
  const SupportValue h = check(points, Vector::Ones(3));
  EXPECT_EQ(h.value, 0);
  EXPECT_EQ(h.error, 0);
}

TEST_P(SupportValueOnEveryKernel, HoldsWhereMorePointsAreDoubtfulThanAreLookedAtAgain) {
  Random random(44);
  Eigen::MatrixXd points(3, 3000);
  points.row(0) = gaussian_points(1, 3000, random);
  points.row(1) = -points.row(0);
  points.row(2) = 1e-17 * gaussian_points(1, 3000, random);
  check(points, Vector::Ones(3));
}

TEST_P(SupportValueOnEveryKernel, ClaimsNothingWhereProductsOverflow) {
  Eigen::MatrixXd points(2, 2);
  points << 1e200, -1e200, 1e200, 1e200;
  for (const double sign : {1.0, -1.0}) {
    const Vector u = sign * (Vector(2) << 1e200, -1e200).finished();
    const SupportValue h = check(points, u);
    EXPECT_TRUE(std::isinf(h.error));
  }
}

TEST(DotError, BoundsTheErrorOfAnyOrderOfSummation) {
  Random random(45);
  for (const int exponent : {0, -300, -530, 300}) {
    for (int n = 1; n <= 20; ++n) {
      const Eigen::MatrixXd points = std::ldexp(1.0, exponent) * gaussian_points(n, 20, random);
      const Vector u = std::ldexp(1.0, exponent < -500 ? exponent : 0) * gaussian_points(n, 1, random);
      const Rational bound = Rational(dot_error(PointSet(points), u.data()));
      for (int i = 0; i < 20; ++i) {
        double forward = 0;
        double backward = 0;
        for (int k = 0; k < n; ++k) {
          forward += u[k] * points(k, i);
          backward = std::fma(u[n - 1 - k], points(n - 1 - k, i), backward);
        }
        const Rational exact = exact_dot(points.col(i), u);
        EXPECT_LE(abs(exact - Rational(forward)), bound);
        EXPECT_LE(abs(exact - Rational(backward)), bound);
      }
    }
  }
}

// lower_bound must not exceed the exact quotient of the worst values its arguments allow.
void check_lower_bound(const SupportValue& h_A, const SupportValue& h_Q) {
  const double bound = lower_bound(h_A, h_Q);
  ASSERT_GE(bound, 0);
  const Rational largest_A = Rational(h_A.value) + Rational(h_A.error);
  const Rational largest_Q = Rational(h_Q.value) + Rational(h_Q.error);
  if (largest_A >= 0) {
    EXPECT_EQ(bound, 0);
  } else if (std::isinf(bound)) {
    EXPECT_LE(largest_Q, 0) << "h_A = " << h_A.value << ", h_Q = " << h_Q.value;
  } else if (largest_Q > 0) {
    EXPECT_LE(Rational(bound), -largest_A / largest_Q) << "h_A = " << h_A.value << ", h_Q = " << h_Q.value;
  }
}

TEST(LowerBound, IsNeverAboveTheExactQuotient) {
  Random random(46);
  std::normal_distribution<double> normal;
  for (const int exponent_A : {0, -500, 500, -1060, -1073, 1000}) {
    for (const int exponent_Q : {0, -500, 500, -1060, -1073, 1000}) {
      for (int trial = 0; trial < 200; ++trial) {
        const double a = std::ldexp(normal(random), exponent_A);
        const double q = std::ldexp(normal(random), exponent_Q);
        const double relative = trial % 3 == 0 ? 0 : std::ldexp(1.0, -(trial % 60));
        check_lower_bound({a, std::fabs(a) * relative}, {q, std::fabs(q) * relative});
      }
    }
  }
}

TEST(LowerBound, LosesNoMoreThanAFewRoundingErrors) {
  EXPECT_GE(lower_bound({-3, 0}, {2, 0}), 1.5 * (1 - 16 * Limits::epsilon()));
  EXPECT_LE(lower_bound({-3, 0}, {2, 0}), 1.5);
}

TEST(LowerBound, IsZeroWhereNegativityIsNotCertain) {
  EXPECT_EQ(lower_bound({-1e-20, 1e-18}, {1, 0}), 0);
  EXPECT_EQ(lower_bound({0, 0}, {1, 0}), 0);
  EXPECT_EQ(lower_bound({-1, Limits::infinity()}, {1, 0}), 0);
  EXPECT_EQ(lower_bound({-1, 0}, {1, Limits::infinity()}), 0);
}

TEST(LowerBound, IsInfiniteForAFarkasDirectionOnly) {
  EXPECT_EQ(lower_bound({-1, 0}, {0, 0}), Limits::infinity());
  EXPECT_EQ(lower_bound({-1, 0}, {-2, 1}), Limits::infinity());
  EXPECT_LT(lower_bound({-1, 0}, {-2, 3}), Limits::infinity());
  EXPECT_EQ(lower_bound({-1e300, 0}, {1e-300, 0}), Limits::max());  // the quotient overflows
}

TEST(LowerBound, IsNeverNaN) {
  for (const double error : {0.0, 1.0, Limits::infinity()}) {
    for (const double value : {-1.0, 0.0, 1.0, Limits::infinity(), -Limits::max(), Limits::max()}) {
      EXPECT_FALSE(std::isnan(lower_bound({-1, 0}, {value, error}))) << value << " ± " << error;
      EXPECT_FALSE(std::isnan(lower_bound({value, error}, {1, 0}))) << value << " ± " << error;
    }
  }
}

TEST(ScaledBounds, AreExactWhereTheResultIsANormalNumber) {
  EXPECT_EQ(scaled_down(3, 4), 48);
  EXPECT_EQ(scaled_up(3, -4), 0.1875);
  EXPECT_EQ(scaled_down(0, 100), 0);
  EXPECT_EQ(scaled_up(0, 100), 0);
}

TEST(ScaledBounds, RoundOutwardsBelowAndAboveTheNormalRange) {
  Random random(47);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const double value = std::fabs(normal(random));
    const int shift = -1010 - trial % 80;
    const Rational exact = Rational(std::ldexp(value, -500)) * Rational(std::ldexp(1.0, shift + 500));
    EXPECT_LE(Rational(scaled_down(value, shift)), exact) << value << " · 2^" << shift;
    EXPECT_GE(Rational(scaled_up(value, shift)), exact) << value << " · 2^" << shift;
  }
  EXPECT_EQ(scaled_down(1, 2000), Limits::max());
  EXPECT_EQ(scaled_up(1, 2000), Limits::infinity());
  EXPECT_EQ(scaled_down(Limits::infinity(), -3), Limits::infinity());
}

}  // namespace
}  // namespace raygauge::test_certificate
