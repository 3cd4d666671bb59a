// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/integer_basis.h"

#include <utility>

#include "engine/numerics/splitmix64.h"

namespace raygauge {

void IntegerBasis::reset(int m) {
  m_ = m;
  w_.resize(at(m));
  id_.assign(at(m), -1);
  M_.assign(at(m) * at(m + 1), {});
  D_.assign_scaled(1, 0);
  for (int i = 0; i < m; ++i) M_[entry(i, i)].assign_scaled(1, 0);
}

void IntegerBasis::add_row(int i, std::vector<BigInteger>& sum) const {
  for (int k = 0; k < m_; ++k) sum[at(k)].add(M_[entry(i, k)]);
}

bool IntegerBasis::has_reached() const {
  for (int i = 0; i < m_; ++i) {
    if (is_artificial(i) && !x(i).is_zero()) return false;
  }
  return true;
}

void IntegerBasis::transform(const std::vector<BigInteger>& c, Deadline& deadline) {
  for (int i = 0; i < m_; ++i) {
    if (deadline.is_over()) return;
    w_[at(i)].clear();
    for (int k = 0; k < m_; ++k) {
      product_.assign_product(M_[entry(i, k)], c[at(k)]);
      w_[at(i)].add(product_);
    }
  }
}

int IntegerBasis::free_row() const {
  int row = -1;
  for (int i = 0; i < m_; ++i) {
    if (!is_artificial(i) || w_[at(i)].is_zero()) continue;
    if (row < 0 || w_[at(i)].bit_length() < w_[at(row)].bit_length()) row = i;
  }
  return row;
}

int IntegerBasis::leaving_row(bool at_zero) const {
  int row = -1;
  for (int i = 0; i < m_; ++i) {
    if (at_zero && is_artificial(i) && !w_[at(i)].is_zero()) return i;
    if (w_[at(i)].sign() > 0 && (row < 0 || ratio_is_less(i, row))) row = i;
  }
  return row;
}

// x_i / w_i < x_r / w_r; among equals artificial variables go first, then the perturbation decides.
bool IntegerBasis::ratio_is_less(int i, int r) const {
  const BigInteger& w_i = w_[at(i)];
  const BigInteger& w_r = w_[at(r)];
  BigInteger left;
  BigInteger right;
  left.assign_product(x(i), w_r);
  right.assign_product(x(r), w_i);
  if (left != right) return left < right;
  if (is_artificial(i) != is_artificial(r)) return is_artificial(i);
  left.assign_product(perturbed(i), w_r);
  right.assign_product(perturbed(r), w_i);
  return left < right;
}

void IntegerBasis::replace(int r, std::int64_t id, Deadline& deadline) {
  const BigInteger p = w_[at(r)];
  divisor_.assign(D_);
  for (int i = 0; i < m_; ++i) {
    if (i == r) continue;
    if (deadline.is_over()) return;
    const BigInteger& w = w_[at(i)];
    for (int k = 0; k <= m_; ++k) {
      product_.assign_product(p, M_[entry(i, k)]);
      other_product_.assign_product(w, M_[entry(r, k)]);
      product_.subtract(other_product_);
      divisor_.divide(product_);
      std::swap(M_[entry(i, k)], product_);
    }
  }
  D_ = p;
  if (D_.sign() < 0) {
    D_.negate();
    for (BigInteger& entry : M_) entry.negate();
  }
  id_[at(r)] = id;
}

void IntegerBasis::make_nonnegative() {
  for (int i = 0; i < m_; ++i) {
    if (x(i).sign() >= 0) continue;
    for (int k = 0; k < m_; ++k) M_[entry(i, k)].negate();
    id_[at(i)] = -1;
  }
}

void IntegerBasis::perturb() {
  constexpr std::uint64_t kDistinct = 1U << 20;
  for (int i = 0; i < m_; ++i) {
    product_.assign_scaled(static_cast<double>(1 + splitmix64(static_cast<std::uint64_t>(i)) % kDistinct), 0);
    M_[entry(i, m_)].assign_product(D_, product_);
  }
}

}  // namespace raygauge
