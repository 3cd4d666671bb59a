// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/gradient.h"

#include <cmath>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

const Vector& usable_normal(const DistanceResult& result) {
  if (result.normal.size() == 0 || !(result.lower > 0) || !std::isfinite(result.upper)) {
    throw InvalidParameterError(
        "gradient: needs a result with a finite distance above zero, got one that is " +
        std::string(to_string(result.status)));
  }
  return result.normal;
}

}  // namespace

Vector gradient_moving_A(const DistanceResult& result) { return -usable_normal(result); }

Vector gradient_moving_Q(const DistanceResult& result) { return result.distance * usable_normal(result); }

}  // namespace raygauge
