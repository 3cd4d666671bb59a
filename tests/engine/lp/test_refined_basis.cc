// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/refined_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "raygauge/sets/convex_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_refined_basis {
namespace {

using Matrix = Eigen::MatrixXd;
constexpr double kNone = std::numeric_limits<double>::infinity();

class RefinedBasisOnEveryKernel : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }

  // Columns of even index are points of A, the others of Q: costs 0 and 1.
  void fill(const Matrix& B, const Vector& b) {
    const int m = static_cast<int>(B.rows());
    basis_.reset(m, kernels());
    for (int i = 0; i < m; ++i) basis_.set_column(i, B.col(i).data(), i % 2, i);
    for (int i = 0; i < m; ++i) basis_.right_hand_side()[i] = b[i];
    ASSERT_TRUE(basis_.refactor());
  }

  // Σβ exactly.
  static Rational sum_of_Q(const Vector& x) {
    Rational sum = 0;
    for (Eigen::Index i = 1; i < x.size(); i += 2) sum += Rational(x[i]);
    return sum;
  }

  Basis basis_;
  RefinedBasis refined_;
};

INSTANTIATE_TEST_SUITE_P(Machine, RefinedBasisOnEveryKernel, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Integers, so that b = B x holds exactly; nearly parallel columns make the condition what it is asked to be.
Matrix ill_conditioned(int m, double spread, Random& random) {
  Matrix B = integer_points(m, m, 9, random) + 12 * Matrix::Identity(m, m);
  B.col(m - 1) = B.col(0);
  B.col(m - 1) += spread * integer_points(m, 1, 3, random) + Vector::Unit(m, m - 1) * spread;
  return B;
}

// The bound grows as (2 m)² 2^-106 |B⁻¹||B|: 1e-27 times 1e12 where the condition is worst.
constexpr double kTight = 1e-14;

TEST_P(RefinedBasisOnEveryKernel, BoundsTheExactSolutionToTheLastDigitsWhateverTheCondition) {
  Random random(31);
  for (const int m : {3, 8, 17, 51}) {
    for (const int bits : {0, 10, 20, 30}) {
      const Matrix B = ill_conditioned(m, std::ldexp(1.0, -bits), random);
      const Vector x = integer_points(m, 1, 3, random).cwiseAbs() + Vector::Ones(m);
      fill(B, B * x);
      const double upper = refined_.upper(basis_, kernels());
      EXPECT_GE(Rational(upper), sum_of_Q(x)) << "m = " << m << ", bits = " << bits;
      EXPECT_LE(upper, sum_of_Q(x).convert_to<double>() * (1 + kTight)) << "m = " << m << ", bits = " << bits;
    }
  }
}

TEST_P(RefinedBasisOnEveryKernel, SolvesForTheDualsToThirtyDigits) {
  Random random(32);
  for (const int m : {3, 8, 17, 51}) {
    const Matrix B = ill_conditioned(m, 0x1p-20, random);
    fill(B, Vector::Ones(m));
    refined_.refine_duals(basis_, kernels());
    for (int j = 0; j < m; ++j) {
      Rational residual = -(j % 2);
      Rational magnitude = 1;
      for (int k = 0; k < m; ++k) {
        const Rational y = Rational(basis_.view().y[k]) + Rational(refined_.dual_low()[k]);
        residual += y * Rational(B(k, j));
        magnitude += abs(y * Rational(B(k, j)));
      }
      EXPECT_LE(abs(residual).convert_to<double>(), 1e-28 * magnitude.convert_to<double>());
    }
  }
}

TEST_P(RefinedBasisOnEveryKernel, LeavesWeightsThatAreZeroToTheResidual) {
  Random random(33);
  for (const int m : {4, 9, 30}) {
    const Matrix B = ill_conditioned(m, 0x1p-20, random);
    Vector x = integer_points(m, 1, 3, random).cwiseAbs() + Vector::Ones(m);
    x[1] = x[2] = 0;
    fill(B, B * x);
    EXPECT_EQ(refined_.upper(basis_, kernels()), kNone) << "m = " << m;
    Rational alpha = 0;
    for (Eigen::Index i = 0; i < m; i += 2) alpha += Rational(x[i]);
    const Rational ratio = sum_of_Q(x) / alpha;
    const double upper = refined_.upper_with_residual(basis_, kernels(), 100);
    EXPECT_GE(Rational(upper), ratio) << "m = " << m;
    EXPECT_LE(upper, ratio.convert_to<double>() * (1 + 1e-14)) << "m = " << m;
  }
}

TEST_P(RefinedBasisOnEveryKernel, ClaimsNothingOfNegativeWeightsArtificialColumnsOrOverflow) {
  Random random(34);
  const int m = 9;
  const Matrix B = integer_points(m, m, 9, random) + 20 * Matrix::Identity(m, m);
  Vector x = Vector::Ones(m);
  x[3] = -0x1p-20;
  fill(B, B * x);
  EXPECT_EQ(refined_.upper(basis_, kernels()), kNone);
  EXPECT_EQ(refined_.upper_with_residual(basis_, kernels(), 1), kNone);
  fill(B, B * Vector::Ones(m));
  basis_.view().id[4] = -1;
  EXPECT_EQ(refined_.upper(basis_, kernels()), kNone);
  EXPECT_EQ(refined_.upper_with_residual(basis_, kernels(), 1), kNone);
  fill(B, B * Vector::Ones(m));
  basis_.view().x()[0] = 1e308;
  const double upper = refined_.upper(basis_, kernels());
  EXPECT_TRUE(upper == kNone || Rational(upper) >= sum_of_Q(Vector::Ones(m))) << upper;
}

}  // namespace
}  // namespace raygauge::test_refined_basis
