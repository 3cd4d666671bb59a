// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace raygauge {

/// An unevaluated sum high + low of two doubles (Dekker; Hida, Li & Bailey): about 106 bits. The operations
/// below lose at most 2⁻¹⁰² relative to the sum of the magnitudes involved, barring underflow.
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

/// a · b without error, barring underflow.
inline DoubleDouble two_product(double a, double b) noexcept {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble s = two_sum(a.high, b.high);
  const DoubleDouble t = two_sum(a.low, b.low);
  const DoubleDouble r = two_sum(s.high, s.low + t.high);
  return two_sum(r.high, r.low + t.low);
}

inline DoubleDouble operator+(const DoubleDouble& a, double b) noexcept { return a + DoubleDouble{b, 0}; }
inline DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + (-b); }

inline DoubleDouble operator*(const DoubleDouble& a, double b) noexcept {
  const DoubleDouble p = two_product(a.high, b);
  return two_sum(p.high, p.low + a.low * b);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble p = two_product(a.high, b.high);
  return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// Two Newton steps on the quotient of the high parts.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  const DoubleDouble last = rest - b * second;
  return two_sum(first, second) + last.high / b.high;
}

/// √a for a >= 0; 0 for a < 0.
inline DoubleDouble sqrt(const DoubleDouble& a) noexcept {
  if (!(a.high > 0)) return {};
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(root, root);
  return two_sum(root, rest.high / (2 * root));
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b < a; }
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high > b.high || (a.high == b.high && a.low >= b.low);
}

}  // namespace raygauge
