// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/proven_bounds.h"

#include <algorithm>
#include <limits>

#include "engine/certificates/certificate.h"

namespace raygauge {

void tighten(const ProvenBounds& proven, int n, double tolerance, DistanceResult& result) {
  const bool final =
      result.status == DistanceStatus::contains_origin || result.status == DistanceStatus::unreachable;
  if (final || !(proven.lower > result.lower || proven.upper < result.upper)) return;
  if (proven.lower > result.upper || proven.upper < result.lower) return;  // no two proofs do that
  if (proven.lower > result.lower) {
    result.lower = proven.lower;
    result.normal = Vector::Map(proven.normal, n);
  }
  result.upper = std::min(result.upper, proven.upper);
  const double largest = std::min(result.upper, std::numeric_limits<double>::max());
  result.distance = std::clamp(result.distance, result.lower, std::max(result.lower, largest));
  if (is_closed(result.lower, result.upper, tolerance)) result.status = DistanceStatus::optimal;
}

void set_overlap(DistanceResult& result) {
  result.status = DistanceStatus::contains_origin;
  result.distance = result.lower = result.upper = 0;
  result.normal.resize(0);
  result.contact_point.resize(0);
}

}  // namespace raygauge
