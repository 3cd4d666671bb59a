// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double lower = 0;
  double upper = kInfinity;

  /// Relative width; 0 for a point, be it 0 or +∞.
  double width() const { return lower == upper ? 0 : (upper - lower) / upper; }
};

Interval interval_of(const Record& record) {
  return {std::isnan(record.lower) ? 0 : record.lower, std::isnan(record.upper) ? kInfinity : record.upper};
}

/// lower <= upper, up to the part `slack` of lower. Holds for +∞ only if both are; never for a NaN.
bool ordered(double lower, double upper, double slack) { return lower * (1 - slack) <= upper; }

bool meet(const Interval& a, const Interval& b) {
  return ordered(std::max(a.lower, b.lower), std::min(a.upper, b.upper), kAgreementRounding);
}

bool is_final(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
}

bool proofs_meet(const Record& record, std::span<const Record> records) {
  const Interval own = interval_of(record);
  const bool meets_all = std::all_of(records.begin(), records.end(),
                                     [&](const Record& other) { return meet(own, interval_of(other)); });
  if (std::isnan(record.exact_distance)) return meets_all;
  return meets_all && meet(own, {record.exact_distance, record.exact_distance});
}

bool claim_holds(const Record& record, std::span<const Record> records, const Interval& narrowest) {
  if (!is_final(record.status)) return true;
  const bool same_status = std::all_of(records.begin(), records.end(), [&](const Record& other) {
    return !is_final(other.status) || other.status == record.status;
  });
  // A distance of NaN fails both comparisons, as it should.
  return same_status && ordered(narrowest.lower, record.distance, record.tolerance) &&
         ordered(record.distance, narrowest.upper, record.tolerance);
}

}  // namespace

void mark_agreement(std::span<Record> records) {
  Interval narrowest;
  double smallest_width = kInfinity;
  for (const Record& record : records) {
    const Interval candidate = interval_of(record);
    // An empty or unbounded interval (its width is negative or NaN) is no measure for others.
    if (const double width = candidate.width(); width >= 0 && width < smallest_width) {
      narrowest = candidate;
      smallest_width = width;
    }
  }
  for (Record& record : records) {
    record.agrees = proofs_meet(record, records) && claim_holds(record, records, narrowest);
  }
}

}  // namespace raygauge
