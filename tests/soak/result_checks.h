// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "raygauge/methods/result.h"

namespace raygauge::soak {

inline bool is_final(const DistanceResult& r) {
  return r.status == DistanceStatus::optimal || r.status == DistanceStatus::contains_origin;
}

/// What a result says that its own bounds contradict; empty if nothing.
inline std::string wrong_status(const DistanceResult& r, double tolerance) {
  if (!(r.lower >= 0 && r.lower <= r.upper)) return "not 0 <= lower <= upper";
  if (r.status != DistanceStatus::optimal) return "";
  const bool narrow = std::isfinite(r.upper) && r.upper - r.lower <= tolerance * r.upper;
  return narrow ? "" : "optimal, but wider than the tolerance";
}

}  // namespace raygauge::soak
