// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/double_double.h"

namespace raygauge {

/// mantissa · 2^exponent with 1 <= |mantissa| < 2, or zero: a number of any magnitude to about 106 bits.
struct ScaledDouble {
  DoubleDouble mantissa;
  std::int64_t exponent = 0;
};

/// An integer of any size: a sign and limbs of 64 bits, lowest first. Only what a fraction-free simplex
/// needs: products, differences and divisions known to leave no remainder. Operations write into their object
/// and reuse its memory.
class BigInteger {
 public:
  using Limb = std::uint64_t;

  BigInteger() = default;

  /// Becomes value · 2^shift, which must be an integer (value finite).
  void assign_scaled(double value, std::int64_t shift);
  /// Becomes a · b. Neither may be this object.
  void assign_product(const BigInteger& a, const BigInteger& b);
  void add(const BigInteger& other);
  void subtract(const BigInteger& other);
  void clear() noexcept {
    limbs_.clear();
    negative_ = false;
  }
  void negate() noexcept { negative_ = !negative_ && !limbs_.empty(); }
  void shift_left(std::int64_t bits);

  int sign() const noexcept { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }
  bool is_zero() const noexcept { return limbs_.empty(); }
  /// floor(log2 |value|) + 1; 0 for zero.
  std::int64_t bit_length() const noexcept;
  /// The value to a relative error of 2⁻¹⁰⁰.
  ScaledDouble approximate() const;

  friend std::strong_ordering operator<=>(const BigInteger& a, const BigInteger& b) noexcept;
  friend bool operator==(const BigInteger& a, const BigInteger& b) noexcept = default;

 private:
  friend class ExactDivisor;
  void trim() noexcept;
  void shift_right(std::int64_t bits);
  void add_signed(const BigInteger& other, bool other_negative);

  bool negative_ = false;
  std::vector<Limb> limbs_;
};

/// A positive divisor, prepared for many divisions without remainder (Jebelean 1993: the quotient comes limb
/// by limb from the low end, by multiplication with the inverse modulo 2⁶⁴).
class ExactDivisor {
 public:
  void assign(const BigInteger& divisor);
  /// dividend /= divisor; wrong if that leaves a remainder.
  void divide(BigInteger& dividend) const;

 private:
  BigInteger odd_;  // divisor = odd · 2^shift
  std::int64_t shift_ = 0;
  BigInteger::Limb inverse_ = 1;
};

/// The two neighbouring doubles around numerator / denominator · 2^exponent (equal where that is a double).
struct RoundedRatio {
  double below = 0;
  double above = 0;
  double nearest = 0;
};

/// numerator >= 0, denominator > 0. A value beyond the largest double has above = +infinity.
RoundedRatio rounded_ratio(BigInteger numerator, BigInteger denominator, std::int64_t exponent);

}  // namespace raygauge
