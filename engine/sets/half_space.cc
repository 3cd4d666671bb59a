// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/half_space.h"

#include <cmath>
#include <typeinfo>

#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

[[noreturn]] void refuse() {
  throw InvalidParameterError(
      "a half-space is not bounded: with a bounded object it has a distance, a depth and a separation, in "
      "scenes too, and nothing else");
}

}  // namespace

HalfSpace::HalfSpace(const ConstVectorRef& normal, double offset)
    : ConvexSet(static_cast<int>(normal.size())),
      normal_(checked_finite("half_space", "normal", normal)),
      offset_(offset) {
  if (!std::isfinite(offset)) throw NonFiniteError("half_space: offset must be finite");
  const double largest = normal_.lpNorm<Eigen::Infinity>();
  if (largest == 0) throw InvalidParameterError("half_space: normal must not be 0");
  const int shift = -std::ilogb(largest);
  for (double& entry : normal_) entry = std::scalbn(entry, shift);
  offset_ = std::scalbn(offset, shift);
  if (!std::isfinite(offset_) || std::scalbn(offset_, -shift) != offset) {
    throw InvalidParameterError("half_space: offset / |normal| is out of the range of numbers");
  }
}

double HalfSpace::do_support(const double* /*u*/, double* /*point*/) const { refuse(); }
void HalfSpace::do_center(double* /*point*/) const { refuse(); }
void HalfSpace::do_magnitude(double* /*magnitude*/) const { refuse(); }

// A final class has no subclasses: quicker than a cast that looks for them.
const HalfSpace* as_half_space(const ConvexSet& S) noexcept {
  return typeid(S) == typeid(HalfSpace) ? static_cast<const HalfSpace*>(&S) : nullptr;
}

}  // namespace raygauge
