// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/numerics/double_double.h"
#include "raygauge/sets/convex_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_basis {
namespace {

using Matrix = Eigen::MatrixXd;

// B⁻¹ b by Gauss–Jordan in rational arithmetic; empty for a singular B.
std::optional<std::vector<Rational>> exact_solution(const Matrix& B, const Vector& b) {
  const auto m = static_cast<std::size_t>(B.rows());
  std::vector<std::vector<Rational>> rows(m, std::vector<Rational>(m + 1));
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      rows[i][j] = B(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
    rows[i][m] = b[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t k = 0; k < m; ++k) {
    std::size_t pivot = k;
    while (pivot < m && rows[pivot][k] == 0) ++pivot;
    if (pivot == m) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < m; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const Rational multiple = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= m; ++j) rows[i][j] -= multiple * rows[k][j];
    }
  }
  std::vector<Rational> x(m);
  for (std::size_t i = 0; i < m; ++i) x[i] = rows[i][m] / rows[i][i];
  return x;
}

void fill(Basis& basis, const Matrix& B, const Vector& b, const Vector& cost,
          const Kernels& kernels = best_kernels()) {
  const int m = static_cast<int>(B.rows());
  basis.reset(m, kernels);
  for (int i = 0; i < m; ++i) basis.set_column(i, B.col(i).data(), cost[i], i);
  for (int i = 0; i < m; ++i) basis.right_hand_side()[i] = b[i];
}

Matrix inverse_of(const Basis& basis) {
  const BasisView& view = basis.view();
  return Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>(view.R, view.m, view.m,
                                                           Eigen::OuterStride<>(view.P));
}

// Whether a claimed enclosure contains the exact solution.
::testing::AssertionResult enclosure_is_true(const Basis& basis, const Enclosure& enclosure, const Matrix& B,
                                             const Vector& b) {
  if (!enclosure.valid) return ::testing::AssertionSuccess() << "nothing claimed";
  const auto exact = exact_solution(B, b);
  if (!exact) return ::testing::AssertionFailure() << "a singular matrix was called regular";
  if (!std::isfinite(enclosure.error)) return ::testing::AssertionSuccess();
  for (std::size_t i = 0; i < exact->size(); ++i) {
    const Rational off = (*exact)[i] - Rational(basis.view().x()[i]);
    if (abs(off) > Rational(enclosure.error)) {
      return ::testing::AssertionFailure()
             << "x_" << i << " is off by " << off.convert_to<double>() << ", claimed " << enclosure.error;
    }
  }
  return ::testing::AssertionSuccess();
}

class BasisOnEveryKernel : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }

  // Whether an enclosure of B⁻¹ b was claimed; it must then be true.
  bool claims(const Matrix& B, const Vector& b) {
    fill(basis_, B, b, Vector::Ones(B.rows()), kernels());
    if (!basis_.refactor()) return false;
    const Enclosure enclosure = basis_.enclose(true);
    EXPECT_TRUE(enclosure_is_true(basis_, enclosure, B, b)) << "B =\n" << B << "\nb = " << b.transpose();
    return enclosure.valid;
  }

  Basis basis_;
};

INSTANTIATE_TEST_SUITE_P(Machine, BasisOnEveryKernel, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

TEST(Basis, InvertsItsColumns) {
  Random random(21);
  Basis basis;
  for (const int m : {1, 2, 3, 6, 9, 11, 21, 51}) {
    const Matrix B = gaussian_points(m, m, random) + 3 * Matrix::Identity(m, m);
    const Vector b = gaussian_points(m, 1, random);
    const Vector cost = gaussian_points(m, 1, random);
    fill(basis, B, b, cost);
    ASSERT_TRUE(basis.refactor());
    const Matrix R = inverse_of(basis);
    // Backward stable up to the condition number, which this bound contains.
    const double tolerance = 1e-15 * m * R.norm() * B.norm();
    EXPECT_LE((R * B - Matrix::Identity(m, m)).norm(), tolerance * R.norm() * B.norm());
    const BasisView& view = basis.view();
    EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(view.x(), m) - R * b).norm(), tolerance * (1 + b.norm()));
    EXPECT_LE((B.transpose() * Eigen::Map<const Eigen::VectorXd>(view.y, m) - cost).norm(),
              tolerance * (1 + cost.norm()));
    EXPECT_NEAR(view.objective, cost.dot(R * b), tolerance * cost.norm() * (1 + b.norm()));
  }
}

TEST(Basis, SaysThatAMatrixIsSingular) {
  Basis basis;
  Matrix B = Matrix::Identity(4, 4);
  B.col(2) = B.col(0) + 2 * B.col(1);
  fill(basis, B, Vector::Ones(4), Vector::Ones(4));
  EXPECT_FALSE(basis.refactor());
  fill(basis, Matrix::Zero(3, 3), Vector::Ones(3), Vector::Ones(3));
  EXPECT_FALSE(basis.refactor());
}

TEST(Basis, ForgetsWhatItHeldBeforeAReset) {
  Random random(22);
  Basis basis;
  fill(basis, gaussian_points(9, 9, random), gaussian_points(9, 1, random), Vector::Ones(9));
  ASSERT_TRUE(basis.refactor());
  fill(basis, 2 * Matrix::Identity(3, 3), Vector::Ones(3), Vector::Ones(3));
  ASSERT_TRUE(basis.refactor());
  EXPECT_EQ(inverse_of(basis), 0.5 * Matrix::Identity(3, 3));
  EXPECT_EQ(basis.view().objective, 1.5);
}

// From 25 rows on changes are collected, sixteen at a time, before the inverse takes them.
TEST_P(BasisOnEveryKernel, KeepsItsInverseThroughManyChanges) {
  const Kernels& kernels = kernels_for(GetParam());
  Random random(27);
  AlignedBuffer<double> column;
  for (const int m : {5, 12, 20, 25, 40, 101}) {
    fill(basis_, Matrix::Identity(m, m), Vector::Ones(m), gaussian_points(m, 1, random), kernels);
    ASSERT_TRUE(basis_.refactor());
    BasisView& view = basis_.view();
    column.reserve(static_cast<std::size_t>(view.P));
    std::fill_n(column.data(), view.P, 0.0);
    for (std::int64_t change = 0; change < 53; ++change) {
      Eigen::Map<Eigen::VectorXd> entering(column.data(), m);
      entering = gaussian_points(m, 1, random) / std::sqrt(m) + Vector::Unit(m, change % m);
      const double cost = 0.01 * static_cast<double>(change);
      const auto enter = [&] {
        const double reduced_cost = cost - entering.dot(Eigen::Map<const Eigen::VectorXd>(view.y, m));
        std::int64_t left = -1;
        return kernels.pivot(&view, column.data(), cost, reduced_cost, m + change, false, &left);
      };
      if (enter() == PivotResult::ok) continue;
      entering = -entering;  // no weight falls along a column, so some do along its opposite
      ASSERT_EQ(enter(), PivotResult::ok);
    }
    EXPECT_EQ(view.pivots, 53);
    EXPECT_LE(basis_.drift(), 1e-8) << "m = " << m;
    const Eigen::Map<const Matrix, 0, Eigen::OuterStride<>> B(view.B, m, m, Eigen::OuterStride<>(view.P));
    const Eigen::Map<const Eigen::VectorXd> costs(view.cost, m);
    const Eigen::Map<const Eigen::VectorXd> x(view.x(), m);
    const double size = Eigen::Map<const Eigen::VectorXd>(view.y, m).norm() + 1;
    EXPECT_LE((B.transpose() * Eigen::Map<const Eigen::VectorXd>(view.y, m) - costs).norm(), 1e-8 * size)
        << "m = " << m;
    EXPECT_NEAR(view.objective, costs.dot(x), 1e-8 * (1 + costs.norm() * x.norm())) << "m = " << m;
    EXPECT_LE(basis_.residual_share(), 1e-6) << "m = " << m;
  }
}

// ‖I - R B‖∞ to 30 digits, and ‖|R| |B|‖∞.
struct Residual {
  double norm = 0, magnitude = 0;
};

Residual residual_of(const Matrix& R, const Matrix& B) {
  Residual residual;
  for (Eigen::Index i = 0; i < R.rows(); ++i) {
    double sum = 0, magnitudes = 0;
    for (Eigen::Index j = 0; j < R.cols(); ++j) {
      DoubleDouble entry{i == j ? -1.0 : 0.0};
      for (Eigen::Index k = 0; k < R.rows(); ++k) {
        entry = entry + two_product(R(i, k), B(k, j));
        magnitudes += std::fabs(R(i, k) * B(k, j));
      }
      sum += std::fabs(entry.rounded());
    }
    residual.norm = std::max(residual.norm, sum);
    residual.magnitude = std::max(residual.magnitude, magnitudes);
  }
  return residual;
}

// The bound on rounding grows with 32 + m / 32, not with m, and not with ‖R‖ ‖B‖: of sheared integers it
// would leave nothing to prove from 500 dimensions on.
TEST_P(BasisOnEveryKernel, BoundsTheResidualOfLargeInversesClosely) {
  Random random(29);
  for (const int m : {1, 7, 31, 32, 33, 64, 65, 200}) {
    for (const double sheared : {0.0, 1.0, 30.0, 300.0}) {
      Matrix B = gaussian_points(m, m, random);
      for (int i = 1; i < m; ++i) B.row(i) += sheared * (random() % 2 == 0 ? 1 : -1) * B.row(i / 16);
      fill(basis_, B, Vector::Ones(m), Vector::Ones(m), kernels());
      ASSERT_TRUE(basis_.refactor());
      const Residual truth = residual_of(inverse_of(basis_), B);
      const double most = truth.norm + (37 + m / 32.0) * 0x1p-53 * truth.magnitude;
      EXPECT_GE(basis_.residual_share(), truth.norm) << "m = " << m << ", " << sheared;
      EXPECT_LE(basis_.residual_share(), 1.1 * (most + 0x1p-50)) << "m = " << m << ", " << sheared;
    }
  }
}

TEST_P(BasisOnEveryKernel, EnclosesTheSolutionOfRandomSystemsTightly) {
  Random random(23);
  for (const int m : {1, 2, 3, 4, 6, 9, 11, 21}) {
    for (int trial = 0; trial < 5; ++trial) {
      const Matrix B = gaussian_points(m, m, random) + 2 * Matrix::Identity(m, m);
      const Vector b = gaussian_points(m, 1, random);
      EXPECT_TRUE(claims(B, b)) << "m = " << m;
      const Matrix R = inverse_of(basis_);
      const double scale = 1e-15 * m * R.lpNorm<1>() * (b.lpNorm<1>() + B.lpNorm<1>() * (R * b).lpNorm<1>());
      EXPECT_LE(basis_.enclose(true).error, scale);
    }
  }
}

TEST_P(BasisOnEveryKernel, ClaimsNothingFalseOfIllConditionedSystems) {
  Random random(24);
  int claimed = 0;
  for (int digits = 0; digits <= 18; ++digits) {
    for (const int m : {2, 3, 5, 9}) {
      Matrix B = gaussian_points(m, m, random);
      B.col(m - 1) =
          B.leftCols(m - 1).rowwise().sum() + std::pow(10.0, -digits) * gaussian_points(m, 1, random);
      if (claims(B, gaussian_points(m, 1, random))) ++claimed;
    }
  }
  EXPECT_GE(claimed, 4 * 10);  // ten digits of cancellation leave a proof within reach
}

TEST_P(BasisOnEveryKernel, ClaimsNothingFalseOfHilbertMatrices) {
  for (int m = 1; m <= 14; ++m) {
    const Matrix B = Matrix::NullaryExpr(
        m, m, [](Eigen::Index i, Eigen::Index j) { return 1.0 / static_cast<double>(i + j + 1); });
    const bool claimed = claims(B, Vector::Unit(m, m - 1));
    if (m <= 8) {
      EXPECT_TRUE(claimed) << "m = " << m;
    }
  }
}

TEST_P(BasisOnEveryKernel, ClaimsNothingFalseOfColumnsOfWildlyDifferentSize) {
  Random random(25);
  for (int trial = 0; trial < 40; ++trial) {
    const int m = 2 + trial % 6;
    Matrix B = gaussian_points(m, m, random);
    for (int j = 0; j < m; ++j) B.col(j) *= std::ldexp(1.0, static_cast<int>(random() % 80) - 40);
    claims(B, Vector::Unit(m, m - 1));
  }
}

TEST_P(BasisOnEveryKernel, NeverCallsASingularMatrixRegular) {
  Random random(26);
  for (int trial = 0; trial < 100; ++trial) {
    const int m = 2 + trial % 7;
    Matrix B = trial % 2 == 0 ? integer_points(m, m, 3, random) : gaussian_points(m, m, random);
    B.col(m - 1) = B.col(0) * 0.5;
    EXPECT_FALSE(claims(B, Vector::Ones(m)));
    Matrix rows = integer_points(m, m, 3, random);
    rows.row(0) = rows.row(m - 1) - (m > 2 ? 2 * rows.row(1) : 0 * rows.row(0));
    EXPECT_FALSE(claims(rows, Vector::Ones(m)));
  }
}

TEST_P(BasisOnEveryKernel, ClaimsNothingFalseOfAnInverseThatHasDrifted) {
  Random random(27);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    const int m = 2 + trial % 8;
    const Matrix B = gaussian_points(m, m, random);
    const Vector b = gaussian_points(m, 1, random);
    fill(basis_, B, b, Vector::Ones(m), kernels());
    ASSERT_TRUE(basis_.refactor());
    BasisView& view = basis_.view();
    const double drift = std::pow(10.0, -(trial % 16));
    for (int k = 0; k <= m; ++k) {
      for (int i = 0; i < m; ++i) view.R[k * view.P + i] *= 1 + drift * normal(random);
    }
    EXPECT_TRUE(enclosure_is_true(basis_, basis_.enclose(true), B, b)) << "drift = " << drift;
  }
}

}  // namespace
}  // namespace raygauge::test_basis
