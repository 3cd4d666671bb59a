// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/gmp.hpp>

namespace raygauge {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

/// A finite double as (odd or zero) mantissa · 2^exponent; exponent 0 for zero.
struct Dyadic {
  long mantissa = 0;
  int exponent = 0;
};

Dyadic to_dyadic(double x);

/// x · 2^shift, which must be an integer.
Integer scaled_integer(double x, long shift);

/// x · 2^shift.
Rational scaled_rational(const Rational& x, long shift);

/// The doubles around a rational x >= 0: lower <= x <= upper, neighbours unless x is a double itself, and the
/// nearest one (ties to even). Above the largest double, upper = nearest = +infinity.
struct RoundedDoubles {
  double lower = 0;
  double nearest = 0;
  double upper = 0;
};

RoundedDoubles round_nonnegative(const Rational& x);

}  // namespace raygauge
