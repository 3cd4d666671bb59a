// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/axis.h"

#include <algorithm>
#include <cmath>

#include "engine/exceptions.h"
#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

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
}

double Axis::radial_part(const double* u, double* radial) const noexcept {
  const auto n = static_cast<int>(direction_.size());
  const double* a = direction_.data();
  const double along = dot(u, a, n);
  for (int k = 0; k < n; ++k) radial[k] = u[k] - along * a[k];
  // What is taken away leaves a rounding error along the axis; where little else is left of u, that error
  // would be scaled up with it and lead out of the set.
  for (int pass = 0; pass < kPasses; ++pass) {
    const double left = dot(radial, a, n);
    for (int k = 0; k < n; ++k) radial[k] -= left * a[k];
    if (std::fabs(left) <= largest_magnitude(radial, n)) return normalize(radial, n, radial);
  }
  std::fill_n(radial, n, 0.0);
  return 0;
}

}  // namespace raygauge
