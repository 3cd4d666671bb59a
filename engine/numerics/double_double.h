// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace raygauge {

/// An unevaluated sum high + low of two doubles (Dekker): about 106 bits. Barring underflow, the operations
/// below lose at most 2⁻¹⁰² relative to the sum of the magnitudes involved: in units of 2⁻¹⁰⁶, and but for
/// higher powers, sums 3, products and roots 5, quotients 12. Where its terms cancel, a sum may lose more
/// relative to itself. (Joldes, Muller & Popescu, "Tight and rigorous error bounds for basic building blocks
/// of double-word arithmetic", 2017, algorithms 5 and 10.)
struct DoubleDouble {
  double high = 0;
  double low = 0;

  /// high + low, rounded to a double.
  double rounded() const noexcept { return high + low; }
};

/// a + b without error.
inline DoubleDouble two_sum(double a, double b) noexcept {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// The same where |a| >= |b|, or a is a multiple of the last bit of b.
inline DoubleDouble ordered_sum(double a, double b) noexcept {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a · b without error, barring underflow.
inline DoubleDouble two_product(double a, double b) noexcept {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// Where the high parts cancel, their sum is still a multiple of the last bit of what is added to it.
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble s = two_sum(a.high, b.high);
  return ordered_sum(s.high, s.low + (a.low + b.low));
}

inline DoubleDouble operator+(const DoubleDouble& a, double b) noexcept { return a + DoubleDouble{b, 0}; }
inline DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + (-b); }

inline DoubleDouble operator*(const DoubleDouble& a, double b) noexcept {
  const DoubleDouble p = two_product(a.high, b);
  return ordered_sum(p.high, p.low + a.low * b);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble p = two_product(a.high, b.high);
  return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// a.high - b.high q is exact for the rounded quotient q; b.high stands for b in the small rest.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double q = a.high / b.high;
  const double rest = std::fma(-b.high, q, a.high) + (a.low - q * b.low);
  return ordered_sum(q, rest / b.high);
}

/// √a for a >= 0; 0 for a < 0.
inline DoubleDouble sqrt(const DoubleDouble& a) noexcept {
  if (!(a.high > 0)) return {};
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(root, root);
  return ordered_sum(root, rest.high / (2 * root));
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b < a; }
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high > b.high || (a.high == b.high && a.low >= b.low);
}

}  // namespace raygauge
