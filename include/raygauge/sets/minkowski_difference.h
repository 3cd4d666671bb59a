// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/minkowski_view.h"

namespace raygauge {

/// A2 - A1 = A2 + (-A1) = {a2 - a1 : a2 in A2, a1 in A1}: d_Q of it is the distance from object A1 to object
/// A2 in the gauge of Q, and it contains the origin where the two meet.
///
///     h(u) = h_A2(u) + h_A1(-u),      s(u) = s_A2(u) - s_A1(-u),      centre c_A2 - c_A1.
class MinkowskiDifference final : public MinkowskiView {
 public:
  /// Throws InvalidParameterError (null pointer) or DimensionMismatchError.
  MinkowskiDifference(std::shared_ptr<const ConvexSet> A2, std::shared_ptr<const ConvexSet> A1);

  const std::shared_ptr<const ConvexSet>& A2() const noexcept { return A2_; }
  const std::shared_ptr<const ConvexSet>& A1() const noexcept { return A1_; }

 private:
  std::shared_ptr<const ConvexSet> A2_;
  std::shared_ptr<const ConvexSet> A1_;
};

}  // namespace raygauge
