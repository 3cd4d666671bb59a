// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/axis.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr int kPasses = 6;  // the first one or two do, but for u along the axis

}  // namespace

Axis::Axis(const std::string& set, const ConstVectorRef& p, const ConstVectorRef& q) {
  check_dimension(set, "the second end of the axis", q.size(), static_cast<int>(p.size()));
  checked_finite(set, "the first end of the axis", p);
  checked_finite(set, "the second end of the axis", q);
  direction_ = 0.5 * q - 0.5 * p;  // halved: the difference of two finite numbers can overflow
  if (normalize(direction_.data(), static_cast<int>(direction_.size()), direction_.data()) == 0) {
    throw InvalidParameterError(set + ": the two ends of the axis must not coincide");
  }
  for (Eigen::Index k = 0; k < p.size(); ++k) quad_direction_.push_back(Quad{q[k]} - p[k]);
  normalize(quad_direction_.data(), static_cast<int>(p.size()), quad_direction_.data());
}

template <>
const double* Axis::components() const noexcept {
  return direction_.data();
}

template <>
const Quad* Axis::components() const noexcept {
  return quad_direction_.data();
}

template <class Real>
Real Axis::radial_part(const Real* u, Real* radial) const noexcept {
  const auto n = static_cast<int>(direction_.size());
  const Real* a = components<Real>();
  const Real along = dot(u, a, n);
  for (int k = 0; k < n; ++k) radial[k] = u[k] - along * a[k];
  // What is taken away leaves a rounding error along the axis; where little else is left of u, that error
  // would be scaled up with it and lead out of the set.
  for (int pass = 0; pass < kPasses; ++pass) {
    const Real left = dot(radial, a, n);
    for (int k = 0; k < n; ++k) radial[k] -= left * a[k];
    if (elementary::fabs(left) <= largest_magnitude(radial, n)) return normalize(radial, n, radial);
  }
  std::fill_n(radial, n, Real{0});
  return 0;
}

template double Axis::radial_part(const double*, double*) const noexcept;
template Quad Axis::radial_part(const Quad*, Quad*) const noexcept;

}  // namespace raygauge
