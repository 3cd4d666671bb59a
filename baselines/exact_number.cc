// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_number.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

bool has_even_mantissa(double x) { return (std::bit_cast<std::uint64_t>(x) & 1U) == 0; }

}  // namespace

Dyadic to_dyadic(double x) {
  if (x == 0) return {};
  constexpr int kDigits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), kDigits));
  const int zeros = std::countr_zero(static_cast<unsigned long>(mantissa));
  return {mantissa / (1L << zeros), exponent - kDigits + zeros};
}

Integer scaled_integer(double x, long shift) {
  const Dyadic dyadic = to_dyadic(x);
  if (dyadic.mantissa == 0) return 0;
  return Integer(dyadic.mantissa) << static_cast<unsigned long>(dyadic.exponent + shift);
}

Rational scaled_rational(const Rational& x, long shift) {
  Rational result;
  if (shift >= 0) {
    mpq_mul_2exp(result.backend().data(), x.backend().data(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpq_div_2exp(result.backend().data(), x.backend().data(), static_cast<mp_bitcnt_t>(-shift));
  }
  return result;
}

RoundedDoubles round_nonnegative(const Rational& x) {
  constexpr double kMax = std::numeric_limits<double>::max();
  if (x > Rational(kMax)) {
    // Half a unit above the largest double is where rounding to nearest goes over to infinity.
    const Rational half_unit = (Rational(kMax) - Rational(std::nextafter(kMax, 0.0))) / 2;
    return {kMax, x < Rational(kMax) + half_unit ? kMax : kInfinity, kInfinity};
  }
  RoundedDoubles result;
  result.lower = mpq_get_d(x.backend().data());  // truncates
  result.upper = Rational(result.lower) == x ? result.lower : std::nextafter(result.lower, kInfinity);
  const Rational twice_middle = Rational(result.lower) + Rational(result.upper);
  const Rational twice_x = x + x;
  const int side = twice_x.compare(twice_middle);
  const bool down = side < 0 || (side == 0 && has_even_mantissa(result.lower));
  result.nearest = down ? result.lower : result.upper;
  return result;
}

}  // namespace raygauge
