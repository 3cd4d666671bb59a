// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/twofold_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_twofold_basis {
namespace {

using Matrix = Eigen::MatrixXd;

class TwofoldBasisOnEveryKernel : public ::testing::TestWithParam<InstructionSet> {
 protected:
  // The columns may take any positions.
  void fill(const Matrix& B) {
    const int m = static_cast<int>(B.rows());
    basis_.reset(m, kernels_for(GetParam()));
    for (int i = 0; i < m; ++i) ASSERT_TRUE(basis_.place(B.col(i).data(), i));
    basis_.refactor();
  }

  // max |R B - I|, computed without rounding.
  double error_of_inverse() const {
    double largest = 0;
    const int m = basis_.size();
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < m; ++j) {
        Rational sum = i == j ? -1 : 0;
        for (int k = 0; k < m; ++k) {
          const Rational entry = Rational(basis_.R(i, k).high) + Rational(basis_.R(i, k).low);
          sum += entry * Rational(basis_.column(j)[k]);
        }
        largest = std::max(largest, std::fabs(sum.convert_to<double>()));
      }
    }
    return largest;
  }

  TwofoldBasis basis_;
};

INSTANTIATE_TEST_SUITE_P(Machine, TwofoldBasisOnEveryKernel, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Two columns that differ by `spread` make the condition 1 / spread.
Matrix ill_conditioned(int m, double spread, Random& random) {
  Matrix B = integer_points(m, m, 9, random) + 12 * Matrix::Identity(m, m);
  B.col(0) = B.col(m - 1) + spread * integer_points(m, 1, 3, random);
  B(0, 0) += 5 * spread;
  B.row(m - 1).setOnes();
  return B;
}

TEST_P(TwofoldBasisOnEveryKernel, InvertsWhereDoublesCannot) {
  Random random(51);
  for (const int m : {2, 3, 9, 25}) {
    for (const int bits : {10, 30, 48}) {
      fill(ill_conditioned(m, std::ldexp(1.0, -bits), random));
      // One unit in the last place of double-double, times the condition and a factor of growth.
      const double tight = std::ldexp(1.0, bits + 20 - 104);
      EXPECT_LE(error_of_inverse(), tight) << "m = " << m << ", bits = " << bits;
      EXPECT_GE(basis_.residual_share(), error_of_inverse()) << "m = " << m << ", bits = " << bits;
      EXPECT_LE(basis_.residual_share(), 0.5) << "m = " << m << ", bits = " << bits;
    }
  }
}

// B x = e_m with an x that is known: integers, of which one column is made.
TEST_P(TwofoldBasisOnEveryKernel, EnclosesTheExactSolution) {
  Random random(52);
  for (const int m : {2, 3, 9, 25}) {
    Matrix B = integer_points(m, m, 999, random);
    const Eigen::VectorXd x = integer_points(m - 1, 1, 9, random);
    B.col(m - 1) = Eigen::VectorXd::Unit(m, m - 1) - B.leftCols(m - 1) * x;
    fill(B);
    TwofoldBasis::Solution solution;
    basis_.solve(solution);
    ASSERT_LT(solution.error, 1e-30) << "m = " << m;
    for (int i = 0; i < m; ++i) {
      const auto at = static_cast<std::size_t>(i);
      Rational difference = basis_.id(i) == m - 1 ? Rational(-1) : Rational(-x[basis_.id(i)]);
      for (const auto& part : solution.part) difference += Rational(part[at]);
      EXPECT_LE(abs(difference), Rational(solution.error)) << "m = " << m << ", i = " << i;
    }
  }
}

TEST_P(TwofoldBasisOnEveryKernel, RefinesDualsToAResidualOfThirtyDigits) {
  Random random(53);
  for (const int m : {3, 9, 25}) {
    fill(ill_conditioned(m, 0x1p-40, random));
    std::vector<double> cost, y(static_cast<std::size_t>(m), 0.0), y_low(y);
    for (int i = 0; i < m; ++i) cost.push_back(i % 2);
    basis_.refine_duals(cost, y.data(), y_low.data());
    for (int i = 0; i < m; ++i) {
      Rational rest = cost[static_cast<std::size_t>(i)];
      double size = 0;
      for (int k = 0; k < m; ++k) {
        const auto at = static_cast<std::size_t>(k);
        rest -= Rational(basis_.column(i)[k]) * (Rational(y[at]) + Rational(y_low[at]));
        size += std::fabs(basis_.column(i)[k] * y[at]);
      }
      EXPECT_LE(std::fabs(rest.convert_to<double>()), 0x1p-98 * (size + 1)) << "m = " << m << ", i = " << i;
    }
  }
}

TEST_P(TwofoldBasisOnEveryKernel, KeepsArtificialColumnsWhereTheyAre) {
  Random random(54);
  const int m = 9;
  basis_.reset(m, kernels_for(GetParam()));
  const Matrix B = ill_conditioned(m, 1, random);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(basis_.place(B.col(i).data(), i));
  std::vector<int> artificial;
  for (int i = 0; i < m; ++i) {
    if (basis_.is_artificial(i)) artificial.push_back(i);
  }
  basis_.make_artificial(artificial[1]);
  basis_.refactor();
  EXPECT_EQ(artificial.size(), 5U);
  for (const int i : artificial) {
    EXPECT_TRUE(basis_.is_artificial(i));
    EXPECT_EQ(std::fabs(basis_.column(i)[i]), 1);
  }
  EXPECT_EQ(basis_.column(artificial[1])[artificial[1]], -1);
  EXPECT_LE(error_of_inverse(), 0x1p-90);
}

TEST_P(TwofoldBasisOnEveryKernel, RefusesAColumnThatDependsOnOthers) {
  basis_.reset(3, kernels_for(GetParam()));
  const Eigen::Vector3d a(1, 2, 3), b(2, 4, 6);
  EXPECT_TRUE(basis_.place(a.data(), 0));
  EXPECT_FALSE(basis_.place(b.data(), 1));
}

}  // namespace
}  // namespace raygauge::test_twofold_basis
