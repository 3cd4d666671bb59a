// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/minkowski_view.h"

namespace raygauge {

/// A + B = {a + b : a in A, b in B}.
///
///     h(u) = h_A(u) + h_B(u),      s(u) = s_A(u) + s_B(u),      centre c_A + c_B.
class MinkowskiSum final : public MinkowskiView {
 public:
  /// Throws InvalidParameterError (null pointer) or DimensionMismatchError.
  MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B);

  const std::shared_ptr<const ConvexSet>& A() const noexcept { return A_; }
  const std::shared_ptr<const ConvexSet>& B() const noexcept { return B_; }

 private:
  std::shared_ptr<const ConvexSet> A_;
  std::shared_ptr<const ConvexSet> B_;
};

}  // namespace raygauge
