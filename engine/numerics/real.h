// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include "engine/numerics/precise_vector.h"

/// What algorithms that are written once for both arithmetics, double and DoubleDouble, ask of a number.
namespace raygauge {

inline double high(double x) noexcept { return x; }
inline double high(const DoubleDouble& x) noexcept { return x.high; }

inline double rounded(double x) noexcept { return x; }
inline double rounded(const DoubleDouble& x) noexcept { return x.rounded(); }
inline const Vector3& rounded(const Vector3& v) noexcept { return v; }

inline double square_root(double x) noexcept { return std::sqrt(x); }
inline DoubleDouble square_root(const DoubleDouble& x) noexcept { return sqrt(x); }

template <class Real>
inline constexpr bool kIsDouble = std::is_same_v<Real, double>;

/// What one operation may lose.
template <class Real>
inline constexpr double kUnitOf = kIsDouble<Real> ? 0x1p-53 : 0x1p-102;

/// a - b of two doubles; without rounding in DoubleDouble.
template <class Real>
Real difference(double a, double b) noexcept {
  if constexpr (kIsDouble<Real>) {
    return a - b;
  } else {
    return two_sum(a, -b);
  }
}

template <class Real>
BasicVector3<Real> vector_of(const Vector3& v) noexcept {
  return {Real{v.x}, Real{v.y}, Real{v.z}};
}

/// M x and Mᵀx for a matrix of doubles.
template <class Real>
BasicVector3<Real> times(const Matrix3& M, const BasicVector3<Real>& x) noexcept {
  const Vector3* c = M.column;
  return {dot(x, Vector3{c[0].x, c[1].x, c[2].x}), dot(x, Vector3{c[0].y, c[1].y, c[2].y}),
          dot(x, Vector3{c[0].z, c[1].z, c[2].z})};
}
template <class Real>
BasicVector3<Real> transposed_times(const Matrix3& M, const BasicVector3<Real>& x) noexcept {
  return {dot(x, M.column[0]), dot(x, M.column[1]), dot(x, M.column[2])};
}

/// |v|, rounded.
template <class Real>
double length_of(const BasicVector3<Real>& v) noexcept {
  return length(rounded(v));
}

template <class Real>
bool is_zero(const BasicVector3<Real>& v) noexcept {
  return high(v.x) == 0 && high(v.y) == 0 && high(v.z) == 0;
}

}  // namespace raygauge
