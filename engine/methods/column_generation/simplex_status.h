// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/primal_simplex.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// What a result says of an end after which nothing more can be done.
inline DistanceStatus status_of(PrimalSimplex::End end) noexcept {
  switch (end) {
    case PrimalSimplex::End::pivot_limit:
      return DistanceStatus::iteration_limit;
    case PrimalSimplex::End::time_limit:
      return DistanceStatus::time_limit;
    default:
      return DistanceStatus::precision_limit;
  }
}

}  // namespace raygauge
