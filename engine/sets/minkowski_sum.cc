// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/operations.h"

#include <utility>

#include "engine/sets/minkowski_view.h"
#include "engine/sets/parameters.h"

namespace raygauge {

MinkowskiSum::MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B)
    : CombinedSet(checked_set("Minkowski sum", "A", A)->dimension()), A_(std::move(A)), B_(std::move(B)) {
  check_dimension("Minkowski sum", "B", checked_set("Minkowski sum", "B", B_)->dimension(), dimension());
  set_view(std::make_unique<MinkowskiView>(ShiftedSum{.S = A_.get(), .T = B_.get()}));
}

MinkowskiDifference::MinkowskiDifference(std::shared_ptr<const ConvexSet> A2,
                                         std::shared_ptr<const ConvexSet> A1)
    : CombinedSet(checked_set("Minkowski difference", "A2", A2)->dimension()),
      A2_(std::move(A2)),
      A1_(std::move(A1)) {
  check_dimension("Minkowski difference", "A1", checked_set("Minkowski difference", "A1", A1_)->dimension(),
                  dimension());
  set_view(std::make_unique<MinkowskiView>(ShiftedSum{.S = A2_.get(), .T = A1_.get(), .sign = -1.0}));
}

}  // namespace raygauge
