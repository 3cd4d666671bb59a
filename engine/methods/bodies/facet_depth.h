// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// What is proven of the depth of a polytope D all facets of which are known: the least height of one.
class FacetDepth {
 public:
  /// Proven of D, with the numbers as they were given.
  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }
  /// Outward, of length 1, of the nearest facet.
  const Vector3& normal() const noexcept { return normal_; }

 protected:
  static constexpr double kHeight = 64 * 0x1p-53;              // lost of h_D(n), relative to the size
  static constexpr double kSmallest = 1e-60, kLargest = 1e60;  // of lengths whose products are squared

  double lower_ = 0, upper_ = 0;
  Vector3 normal_;
};

}  // namespace raygauge
