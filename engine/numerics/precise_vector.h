// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/double_double.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

using PreciseVector3 = BasicVector3<DoubleDouble>;

inline PreciseVector3 precise(const Vector3& v) { return {{v.x, 0}, {v.y, 0}, {v.z, 0}}; }
inline Vector3 rounded(const PreciseVector3& v) { return {v.x.rounded(), v.y.rounded(), v.z.rounded()}; }

/// A product as high + low, where low may be longer than a rounding error of high: for the sums below.
inline DoubleDouble loose_product(double a, double b) noexcept { return two_product(a, b); }
inline DoubleDouble loose_product(const DoubleDouble& a, double b) noexcept {
  const DoubleDouble p = two_product(a.high, b);
  return {p.high, p.low + a.low * b};
}
inline DoubleDouble loose_product(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble p = two_product(a.high, b.high);
  return {p.high, p.low + (a.high * b.low + a.low * b.high)};
}

/// Sums of loose terms that round once, at the end (Ogita, Rump & Oishi, "Accurate sum and dot product",
/// 2005): half as long to wait for as one sum after the other. Products included they lose at most 2⁻¹⁰¹ of
/// the sum of the magnitudes: the low parts are below 5 · 2⁻⁵³ of it, and each of at most five roundings in a
/// row loses 2⁻⁵³ of them.
inline DoubleDouble loose_sum(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble s = two_sum(a.high, b.high);
  return ordered_sum(s.high, s.low + (a.low + b.low));
}
inline DoubleDouble loose_sum(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c) noexcept {
  const DoubleDouble s = two_sum(a.high, b.high);
  const DoubleDouble t = two_sum(s.high, c.high);
  return ordered_sum(t.high, (s.low + t.low) + ((a.low + b.low) + c.low));
}

/// u · v, to 2⁻¹⁰¹ |u||v|.
inline DoubleDouble dot(const PreciseVector3& u, const PreciseVector3& v) noexcept {
  return loose_sum(loose_product(u.x, v.x), loose_product(u.y, v.y), loose_product(u.z, v.z));
}
inline DoubleDouble dot(const PreciseVector3& u, const Vector3& v) noexcept {
  return loose_sum(loose_product(u.x, v.x), loose_product(u.y, v.y), loose_product(u.z, v.z));
}

/// u × v, each coordinate to 2⁻¹⁰¹ |u||v|.
inline PreciseVector3 cross(const PreciseVector3& u, const PreciseVector3& v) noexcept {
  return {loose_sum(loose_product(u.y, v.z), -loose_product(u.z, v.y)),
          loose_sum(loose_product(u.z, v.x), -loose_product(u.x, v.z)),
          loose_sum(loose_product(u.x, v.y), -loose_product(u.y, v.x))};
}

/// a + b + c, rounded once.
inline PreciseVector3 sum_of(const PreciseVector3& a, const PreciseVector3& b,
                             const PreciseVector3& c) noexcept {
  return {loose_sum(a.x, b.x, c.x), loose_sum(a.y, b.y, c.y), loose_sum(a.z, b.z, c.z)};
}

}  // namespace raygauge
