// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_basis.h"

#include "raygauge/exceptions.h"

namespace raygauge {

ExactBasis::ExactBasis(int rows)
    : basic_(static_cast<std::size_t>(rows), kArtificial),
      W_(basic_.size() * basic_.size()),
      y_(basic_.size()) {
  for (int row = 0; row < rows; ++row) W(row, row) = 1;
}

void ExactBasis::add_row(int row, IntegerVector& sum) const {
  for (int k = 0; k < rows(); ++k) sum[static_cast<std::size_t>(k)] += W(row, k);
}

ExactBasis::Step ExactBasis::enter(std::ptrdiff_t j, const IntegerVector& a, bool bland) {
  multiply(a);
  const int row = leaving_row(bland);
  const Step step{column(row), scaled_value(row) != 0};
  pivot(row);
  basic_[static_cast<std::size_t>(row)] = j;
  return step;
}

void ExactBasis::multiply(const IntegerVector& a) {
  for (int row = 0; row < rows(); ++row) {
    Integer& y = y_[static_cast<std::size_t>(row)];
    y = 0;
    for (int k = 0; k < rows(); ++k) y += W(row, k) * a[static_cast<std::size_t>(k)];
  }
}

int ExactBasis::leaving_row(bool bland) const {
  int best = -1;
  for (int row = 0; row < rows(); ++row) {
    const Integer& y = y_[static_cast<std::size_t>(row)];
    if (y <= 0) continue;
    if (best < 0) {
      best = row;
      continue;
    }
    // x_row / y_row against x_best / y_best.
    const Integer left = scaled_value(row) * y_[static_cast<std::size_t>(best)];
    const Integer right = scaled_value(best) * y;
    const int order = left.compare(right);
    const bool wins_tie =
        bland ? column(row) < column(best) : column(row) == kArtificial && column(best) != kArtificial;
    if (order < 0 || (order == 0 && wins_tie)) best = row;
  }
  if (best < 0) throw Error("exact simplex: an improving column has no leaving variable");
  return best;
}

void ExactBasis::pivot(int pivot_row) {
  const auto pivot_value = y_[static_cast<std::size_t>(pivot_row)].backend().data();
  Integer product;
  const auto scratch = product.backend().data();
  for (int row = 0; row < rows(); ++row) {
    if (row == pivot_row) continue;
    const auto factor = y_[static_cast<std::size_t>(row)].backend().data();
    for (int k = 0; k < rows(); ++k) {
      const auto entry = W(row, k).backend().data();
      mpz_mul(scratch, pivot_value, entry);
      mpz_submul(scratch, factor, W(pivot_row, k).backend().data());
      mpz_divexact(entry, scratch, D_.backend().data());
    }
  }
  D_ = y_[static_cast<std::size_t>(pivot_row)];
}

}  // namespace raygauge
