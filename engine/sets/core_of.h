// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// What is left of a set of R^2 or R^3 without the ball that its SpatialShape has: of a capsule the segment,
/// of a ball its centre. S = core + r B. It only looks at the set, which outlives it and has a SpatialShape.
class CoreOf final : public ConvexSet {
 public:
  explicit CoreOf(const ConvexSet& S) : ConvexSet(S.dimension()), set_(S) {}

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override { set_.center_unchecked(point); }
  bool do_spatial_shape(SpatialShape& shape) const override;

  const ConvexSet& set_;
};

}  // namespace raygauge
