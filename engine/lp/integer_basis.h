// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/big_integer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// A stopwatch that is late once and for all: what was left half done stays unused.
class Deadline {
 public:
  explicit Deadline(const Stopwatch* stopwatch = nullptr) noexcept : stopwatch_(stopwatch) {}
  bool is_over() noexcept { return over_ = over_ || stopwatch_->expired(); }
  bool was_over() const noexcept { return over_; }

 private:
  const Stopwatch* stopwatch_;
  bool over_ = false;
};

/// A basis of m integer columns for ExactSimplex, fraction-free (Edmonds; Azulay & Pique 1998): beside
/// D = |det B| it keeps the integer matrix M = D B⁻¹, so that with p = w_r, w = M c, a basis change is
///
///     M_i <- (p M_i - w_i M_r) / D  for i ≠ r,      D <- p,
///
/// divisions that leave no remainder. The right-hand side b is the last unit vector. Degenerate vertices are
/// left by way of a symbolic perturbation: beside x = B⁻¹ b goes B⁻¹ b' with random b' that was positive at
/// the start, and decides among equal ratios.
class IntegerBasis {
 public:
  void reset(int m);  ///< artificial unit columns: M = D = 1

  bool is_artificial(int i) const { return id_[at(i)] < 0; }
  bool is_from_Q(int i) const { return raygauge::is_from_Q(id_[at(i)]); }
  bool is_from_A(int i) const { return !is_artificial(i) && !is_from_Q(i); }
  std::int64_t id(int i) const { return id_[at(i)]; }
  const BigInteger& D() const noexcept { return D_; }
  const BigInteger& x(int i) const { return M_[entry(i, m_ - 1)]; }  ///< D x_i
  void add_row(int i, std::vector<BigInteger>& sum) const;           ///< sum += M_i
  bool has_reached() const;                                          ///< no artificial column has weight

  /// w = M c. The rest is left when the deadline is over.
  void transform(const std::vector<BigInteger>& c, Deadline& deadline);

  /// The transformed column, of that identity, takes position r, at which w is not zero.
  void replace(int r, std::int64_t id, Deadline& deadline);

  /// The artificial position with the shortest w that is not zero; -1: none.
  int free_row() const;

  /// By the ratio test; with `at_zero`, an artificial column that has reached zero must stay there: it leaves
  /// at the first chance.
  int leaving_row(bool at_zero) const;

  /// A basic variable below zero gives way to an artificial one with the negated column: its row changes
  /// sign.
  void make_nonnegative();

  /// Begins the perturbation anew.
  void perturb();

 private:
  static std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
  std::size_t entry(int i, int k) const noexcept { return at(i) * at(m_ + 1) + at(k); }
  const BigInteger& perturbed(int i) const { return M_[entry(i, m_)]; }  // D (B⁻¹ b')_i
  bool ratio_is_less(int i, int r) const;

  int m_ = 0;
  std::vector<BigInteger> M_;  // m rows of m + 1: M and the perturbation
  BigInteger D_;
  std::vector<std::int64_t> id_;
  std::vector<BigInteger> w_;
  ExactDivisor divisor_;
  BigInteger product_, other_product_;
};

}  // namespace raygauge
