// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/column_generation/support_oracle.h"
#include "engine/methods/method.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// Proves `unreachable` where Q touches the origin and A does not reach beyond the tangent plane of Q there.
/// The multiples of such a Q fill the open half-space on its side of the plane, and nothing else: A may lie
/// in that plane, which no Farkas direction separates from them.
class TangentPlane : public Method {
 public:
  /// True and the result where that is proven; otherwise the result stays as it was. A must not hold the
  /// origin.
  bool solve(const Problem& problem, DistanceResult& result) override;

 private:
  SupportOracle oracle_A_;
  AlignedBuffer<double> normal_;  // and the support point along it
};

}  // namespace raygauge
