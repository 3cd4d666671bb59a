// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/operations.h"

#include <utility>

#include "engine/sets/parameters.h"

namespace raygauge {

MinkowskiSum::MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B)
    : MinkowskiView(checked_set("Minkowski sum", "A", A)->dimension()), A_(std::move(A)), B_(std::move(B)) {
  check_dimension("Minkowski sum", "B", checked_set("Minkowski sum", "B", B_)->dimension(), dimension());
  look_at({.S = A_.get(), .T = B_.get()});
}

}  // namespace raygauge
