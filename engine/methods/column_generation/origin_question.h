// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/methods/column_generation/sifting.h"
#include "engine/methods/method.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Whether the origin lies in a set of points, or in the difference of two: exact arithmetic decides it, and
/// it does not depend on Q. It is asked where a method is left with the lower bound 0.
///
/// Of a set A it is d_C(A) for the cross-polytope C, whose multiples reach every point. Of A2 - A1 it is
/// whether any multiple of A1' = A1 × {1} meets A2' = A2 × {1} in R^(n + 1): if so, the multiple is 1.
class OriginQuestion : public Method {
 public:
  /// Where 0 in A is proven: a result with status `contains_origin`, and true.
  bool solve(const Problem& problem, DistanceResult& result) override;
  DistanceCounters counters() const override { return answer_.counters; }

 private:
  bool is_in_points(const PointSet& A, const Problem& problem);
  bool meet(const PointSet& A2, const PointSet& A1, const Problem& problem);

  Sifting sifting_;
  DistanceResult answer_;
};

}  // namespace raygauge
