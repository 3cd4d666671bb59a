// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/big_integer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

using Limb = BigInteger::Limb;
using Limbs = std::vector<Limb>;
__extension__ using Wide = unsigned __int128;

constexpr std::int64_t kLimbBits = 64;

std::strong_ordering compare_magnitudes(const Limbs& a, const Limbs& b) noexcept {
  if (a.size() != b.size()) return a.size() <=> b.size();
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] <=> b[i];
  }
  return std::strong_ordering::equal;
}

void add_magnitude(Limbs& a, const Limbs& b) {
  if (a.size() < b.size()) a.resize(b.size(), 0);
  Limb carry = 0;
  for (std::size_t i = 0; i < a.size() && (i < b.size() || carry != 0); ++i) {
    const Wide sum = static_cast<Wide>(a[i]) + (i < b.size() ? b[i] : 0) + carry;
    a[i] = static_cast<Limb>(sum);
    carry = static_cast<Limb>(sum >> kLimbBits);
  }
  if (carry != 0) a.push_back(carry);
}

// out = larger - smaller; out may be either.
void subtract_magnitudes(const Limbs& larger, const Limbs& smaller, Limbs& out) {
  const std::size_t smaller_size = smaller.size();
  const std::size_t size = larger.size();
  out.resize(size, 0);
  Limb borrow = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Limb taken = i < smaller_size ? smaller[i] : 0;
    const Wide difference = static_cast<Wide>(larger[i]) - taken - borrow;
    out[i] = static_cast<Limb>(difference);
    borrow = static_cast<Limb>(difference >> kLimbBits) & 1U;
  }
}

}  // namespace

void BigInteger::trim() noexcept {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  if (limbs_.empty()) negative_ = false;
}

void BigInteger::assign_scaled(double value, std::int64_t shift) {
  int exponent = 0;
  const double mantissa = std::frexp(std::fabs(value), &exponent);
  limbs_.assign(1, static_cast<Limb>(std::ldexp(mantissa, std::numeric_limits<double>::digits)));
  negative_ = value < 0;
  trim();
  const std::int64_t bits = shift + exponent - std::numeric_limits<double>::digits;
  if (bits >= 0) {
    shift_left(bits);
  } else {
    shift_right(-bits);
  }
}

void BigInteger::assign_product(const BigInteger& a, const BigInteger& b) {
  const Limbs& x = a.limbs_;
  const Limbs& y = b.limbs_;
  negative_ = a.negative_ != b.negative_;
  limbs_.assign(x.empty() || y.empty() ? 0 : x.size() + y.size(), 0);
  for (std::size_t i = 0; i < x.size() && !y.empty(); ++i) {
    Limb carry = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const Wide sum = static_cast<Wide>(x[i]) * y[j] + limbs_[i + j] + carry;
      limbs_[i + j] = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> kLimbBits);
    }
    limbs_[i + y.size()] = carry;
  }
  trim();
}

void BigInteger::add_signed(const BigInteger& other, bool other_negative) {
  if (other.limbs_.empty()) return;
  if (limbs_.empty() || negative_ == other_negative) {
    negative_ = other_negative;
    add_magnitude(limbs_, other.limbs_);
    return;
  }
  if (std::is_gteq(compare_magnitudes(limbs_, other.limbs_))) {
    subtract_magnitudes(limbs_, other.limbs_, limbs_);
  } else {
    subtract_magnitudes(other.limbs_, limbs_, limbs_);
    negative_ = other_negative;
  }
  trim();
}

void BigInteger::add(const BigInteger& other) { add_signed(other, other.negative_); }
void BigInteger::subtract(const BigInteger& other) { add_signed(other, !other.negative_); }

void BigInteger::shift_left(std::int64_t bits) {
  if (limbs_.empty() || bits == 0) return;
  const auto whole = static_cast<std::size_t>(bits / kLimbBits);
  const int rest = static_cast<int>(bits % kLimbBits);
  if (rest != 0) {
    const Limb top = limbs_.back() >> (kLimbBits - rest);
    for (std::size_t i = limbs_.size(); i-- > 1;) {
      limbs_[i] = (limbs_[i] << rest) | (limbs_[i - 1] >> (kLimbBits - rest));
    }
    limbs_[0] <<= rest;
    if (top != 0) limbs_.push_back(top);
  }
  limbs_.insert(limbs_.begin(), whole, 0);
}

void BigInteger::shift_right(std::int64_t bits) {
  const auto whole = std::min(static_cast<std::size_t>(bits / kLimbBits), limbs_.size());
  limbs_.erase(limbs_.begin(), limbs_.begin() + static_cast<std::ptrdiff_t>(whole));
  const int rest = static_cast<int>(bits % kLimbBits);
  if (rest != 0) {
    for (std::size_t i = 0; i < limbs_.size(); ++i) {
      const Limb above = i + 1 < limbs_.size() ? limbs_[i + 1] << (kLimbBits - rest) : 0;
      limbs_[i] = (limbs_[i] >> rest) | above;
    }
  }
  trim();
}

std::int64_t BigInteger::bit_length() const noexcept {
  if (limbs_.empty()) return 0;
  return static_cast<std::int64_t>(limbs_.size()) * kLimbBits - std::countl_zero(limbs_.back());
}

ScaledDouble BigInteger::approximate() const {
  if (limbs_.empty()) return {};
  constexpr std::size_t kTaken = 3;  // limbs: at least 129 bits
  constexpr double kHalf = 0x1p32;
  const std::size_t first = limbs_.size() > kTaken ? limbs_.size() - kTaken : 0;
  const std::int64_t exponent = bit_length() - 1;
  DoubleDouble sum;
  for (std::size_t i = first; i < limbs_.size(); ++i) {
    // Halves of a limb are doubles without rounding.
    const int place = static_cast<int>(static_cast<std::int64_t>(i) * kLimbBits - exponent);
    sum = sum + std::ldexp(static_cast<double>(limbs_[i] & 0xffffffffU), place);
    sum = sum + std::ldexp(kHalf * static_cast<double>(limbs_[i] >> 32), place);
  }
  return {negative_ ? -sum : sum, exponent};
}

std::strong_ordering operator<=>(const BigInteger& a, const BigInteger& b) noexcept {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  const std::strong_ordering order = compare_magnitudes(a.limbs_, b.limbs_);
  if (!a.negative_ || std::is_eq(order)) return order;
  return std::is_lt(order) ? std::strong_ordering::greater : std::strong_ordering::less;
}

void ExactDivisor::assign(const BigInteger& divisor) {
  odd_ = divisor;
  shift_ = 0;
  for (const Limb limb : divisor.limbs_) {
    shift_ += limb == 0 ? kLimbBits : std::countr_zero(limb);
    if (limb != 0) break;
  }
  odd_.shift_right(shift_);
  // Newton: an inverse modulo 2^5 becomes one modulo 2^10, 2^20, 2^40, 2^80.
  const Limb d = odd_.limbs_[0];
  inverse_ = (3 * d) ^ 2U;
  for (int step = 0; step < 4; ++step) inverse_ *= 2 - d * inverse_;
}

void ExactDivisor::divide(BigInteger& dividend) const {
  dividend.shift_right(shift_);
  Limbs& a = dividend.limbs_;
  const Limbs& d = odd_.limbs_;
  if (a.empty() || (d.size() == 1 && d[0] == 1)) return;
  const std::size_t size = a.size() - d.size() + 1;  // of the quotient: only so many limbs of `a` matter
  for (std::size_t i = 0; i < size; ++i) {
    const Limb q = a[i] * inverse_;
    Limb carry = 0;
    for (std::size_t j = 0; j < d.size() && i + j < size; ++j) {
      const Wide product = static_cast<Wide>(q) * d[j] + carry;
      const Limb low = static_cast<Limb>(product);
      carry = static_cast<Limb>(product >> kLimbBits) + (a[i + j] < low ? 1U : 0U);
      a[i + j] -= low;
    }
    for (std::size_t j = i + d.size(); j < size && carry != 0; ++j) {
      const Limb before = a[j];
      a[j] -= carry;
      carry = before < carry ? 1 : 0;
    }
    a[i] = q;
  }
  a.resize(size);
  dividend.trim();
}

RoundedRatio rounded_ratio(BigInteger numerator, BigInteger denominator, std::int64_t exponent) {
  constexpr int kDigits = std::numeric_limits<double>::digits;
  if (numerator.is_zero()) return {};
  // Aligned so that 1/2 < numerator / denominator < 2; then the quotient bit by bit.
  const std::int64_t shift = denominator.bit_length() - numerator.bit_length();
  if (shift >= 0) {
    numerator.shift_left(shift);
  } else {
    denominator.shift_left(-shift);
  }
  exponent -= shift;
  if (numerator < denominator) {
    numerator.shift_left(1);
    --exponent;
  }
  double quotient = 0;
  for (int bit = 0; bit < kDigits; ++bit) {
    quotient *= 2;
    if (numerator >= denominator) {
      numerator.subtract(denominator);
      quotient += 1;
    }
    numerator.shift_left(1);
  }
  // Beyond ±kFarOut every result is 0 or infinite anyway, and an int holds it.
  constexpr std::int64_t kFarOut = 10000;
  const int scale = static_cast<int>(std::clamp(exponent - (kDigits - 1), -kFarOut, kFarOut));
  const double result = std::ldexp(quotient, scale);
  const bool exact = numerator.is_zero() && std::ldexp(result, -scale) == quotient;
  if (exact) return {result, result, result};
  if (std::isinf(result)) return {std::numeric_limits<double>::max(), result, result};
  // Below the normal range ldexp rounds to nearest, up or down.
  const double kept = std::ldexp(result, -scale);
  if (kept > quotient) return {std::nextafter(result, 0.0), result, result};
  const double above = std::nextafter(result, kInfinity);
  const bool nearer_above = kept == quotient && numerator >= denominator;
  return {result, above, nearer_above ? above : result};
}

}  // namespace raygauge
