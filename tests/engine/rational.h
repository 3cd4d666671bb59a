// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#if __has_include(<gmp.h>)
#include <boost/multiprecision/gmp.hpp>
#else  // cross-compiled (tests/cross)
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace raygauge {

/// Doubles are dyadic rationals: with these, a claim about rounding is checked without any.
#if __has_include(<gmp.h>)
using Rational = boost::multiprecision::mpq_rational;
#else
using Rational = boost::multiprecision::cpp_rational;
#endif

/// Σ_k a_k b_k exactly.
template <class Left, class Right>
Rational exact_dot(const Left& a, const Right& b) {
  Rational sum = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) sum += Rational(a[k]) * Rational(b[k]);
  return sum;
}

/// max_i u·p_i over the columns of `points`, exactly.
inline Rational exact_support(const Eigen::MatrixXd& points, const Eigen::VectorXd& u) {
  Rational best = exact_dot(points.col(0), u);
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    const Rational value = exact_dot(points.col(i), u);
    if (value > best) best = value;
  }
  return best;
}

/// Whether lower <= value <= upper, where infinite bounds always hold on their own side.
inline bool encloses(double lower, double upper, const Rational& value) {
  return !(std::isnan(lower) || std::isnan(upper)) &&
         (std::isinf(lower) ? lower < 0 : Rational(lower) <= value) &&
         (std::isinf(upper) ? upper > 0 : value <= Rational(upper));
}

}  // namespace raygauge
