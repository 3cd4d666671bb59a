// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace raygauge {

/// A vector of R^3 in three registers.
template <class Real>
struct BasicVector3 {
  Real x{}, y{}, z{};

  BasicVector3 operator+(const BasicVector3& v) const noexcept { return {x + v.x, y + v.y, z + v.z}; }
  BasicVector3 operator-(const BasicVector3& v) const noexcept { return {x - v.x, y - v.y, z - v.z}; }
  BasicVector3 operator-() const noexcept { return {-x, -y, -z}; }
  BasicVector3 operator*(const Real& s) const noexcept { return {x * s, y * s, z * s}; }
};

using Vector3 = BasicVector3<double>;

template <class Real>
Real dot(const BasicVector3<Real>& u, const BasicVector3<Real>& v) noexcept {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Real>
BasicVector3<Real> cross(const BasicVector3<Real>& u, const BasicVector3<Real>& v) noexcept {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

inline double length(const Vector3& v) noexcept { return std::sqrt(dot(v, v)); }

/// A unit vector orthogonal to v != 0.
inline Vector3 any_orthogonal(const Vector3& v) noexcept {
  const double ax = std::fabs(v.x), ay = std::fabs(v.y), az = std::fabs(v.z);
  const Vector3 axis = ax <= ay && ax <= az ? Vector3{1, 0, 0}
                       : ay <= az           ? Vector3{0, 1, 0}
                                            : Vector3{0, 0, 1};
  const Vector3 w = cross(v, axis);
  return w * (1 / length(w));
}

/// A 3 × 3 matrix by its columns.
struct Matrix3 {
  Vector3 column[3];

  Vector3 operator*(const Vector3& v) const noexcept {
    return column[0] * v.x + column[1] * v.y + column[2] * v.z;
  }
  /// Mᵀv.
  Vector3 transposed_times(const Vector3& v) const noexcept {
    return {dot(column[0], v), dot(column[1], v), dot(column[2], v)};
  }
};

}  // namespace raygauge
