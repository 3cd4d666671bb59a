// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/portable_log.h"

#include <cmath>

namespace raygauge {

// x = m 2^e with m in [√½, √2), and ln m = 2 artanh s = 2 Σ s^(2k+1) / (2k+1) with s = (m-1)/(m+1), |s| <=
// 0.172: the first term left out is below 2^-60 of the sum.
double portable_log(double x) {
  constexpr double kSqrtHalf = 0.70710678118654752440;
  constexpr double kLn2 = 0.69314718055994530942;
  constexpr int kTerms = 12;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < kSqrtHalf) {
    mantissa *= 2;
    --exponent;
  }
  const double s = (mantissa - 1) / (mantissa + 1);
  const double s2 = s * s;
  double sum = 0;
  for (int k = kTerms - 1; k >= 1; --k) sum = (sum + 1.0 / (2 * k + 1)) * s2;
  return exponent * kLn2 + 2 * (s + s * sum);
}

}  // namespace raygauge
