// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_basis.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"

namespace raygauge::test_exact_basis {
namespace {

/// D·e_row·B⁻¹.
IntegerVector scaled_inverse_row(const ExactBasis& basis, int row) {
  IntegerVector sum(static_cast<std::size_t>(basis.rows()));
  basis.add_row(row, sum);
  return sum;
}

Integer product(const IntegerVector& x, const IntegerVector& y) {
  Integer sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k] * y[k];
  return sum;
}

TEST(ExactBasis, StartsWithArtificialColumnsAndTheRightHandSide) {
  const ExactBasis basis(3);
  EXPECT_EQ(basis.determinant(), 1);
  EXPECT_EQ(basis.column(0), ExactBasis::kArtificial);
  EXPECT_EQ(basis.scaled_value(0), 0);
  EXPECT_EQ(basis.scaled_value(2), 1);
}

TEST(ExactBasis, PivotsKeepTheAdjugateOfTheBasis) {
  const std::vector<IntegerVector> columns = {{3, 1, 1}, {-2, 5, 0}, {-7, -11, 0}, {-1, 13, 1}};
  ExactBasis basis(3);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    basis.enter(static_cast<std::ptrdiff_t>(j), columns[j], false);
    for (int row = 0; row < 3; ++row) {
      for (int other = 0; other < 3; ++other) {
        IntegerVector b(3);
        if (basis.column(other) == ExactBasis::kArtificial) {
          b[static_cast<std::size_t>(other)] = 1;
        } else {
          b = columns[static_cast<std::size_t>(basis.column(other))];
        }
        EXPECT_EQ(product(scaled_inverse_row(basis, row), b),
                  row == other ? basis.determinant() : Integer(0));
      }
      EXPECT_GE(basis.scaled_value(row), 0);
    }
    EXPECT_GT(basis.determinant(), 0);
  }
}

TEST(ExactBasis, TiesGoToArtificialColumnsFirst) {
  ExactBasis basis(2);
  basis.enter(4, {1, 0}, false);  // degenerate: takes the place of row 0
  ASSERT_EQ(basis.column(0), 4);
  basis.enter(5, {0, 1}, false);
  ASSERT_EQ(basis.column(1), 5);
  // Rows 0 and 1 have the values 0 and 1: only row 0 can leave, with a step of zero.
  const ExactBasis::Step step = basis.enter(6, {1, 1}, false);
  EXPECT_EQ(step.left, 4);
  EXPECT_FALSE(step.moved);
}

TEST(ExactBasis, ReportsAColumnWithoutLeavingVariable) {
  ExactBasis basis(2);
  EXPECT_THROW(basis.enter(0, {-1, 0}, false), Error);
}

}  // namespace
}  // namespace raygauge::test_exact_basis
