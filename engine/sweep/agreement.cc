// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/agreement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

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

bool all_proofs_meet(const Record& record, std::span<const Record> records) {
  const Interval own = interval_of(record);
  const bool meets_all = std::all_of(records.begin(), records.end(),
                                     [&](const Record& other) { return meet(own, interval_of(other)); });
  const double truth = record.exact_distance;
  if (std::isnan(truth)) return meets_all;
  const double rounding = record.exact_distance_rounding;
  return meets_all && meet(own, {truth * (1 - rounding), truth * (1 + rounding)});
}

/// Whether no other claim contradicts this one. A claim of NaN fails by itself and contradicts nobody.
bool claims_meet(double claim, std::span<const Record> records, double tolerance) {
  return std::all_of(records.begin(), records.end(), [&](const Record& other) {
    const std::optional<double> other_claim = claim_of(other);
    return !other_claim || std::isnan(*other_claim) ||
           ordered(std::max(claim, *other_claim), std::min(claim, *other_claim), tolerance);
  });
}

bool claim_holds(const Record& record, std::span<const Record> records, const Interval& narrowest) {
  const std::optional<double> claim = claim_of(record);
  if (!claim) return true;
  const bool near_proof = ordered(narrowest.lower, *claim, record.tolerance) &&
                          ordered(*claim, narrowest.upper, record.tolerance);
  const bool settled = narrowest.width() <= record.tolerance;
  return near_proof && (settled || claims_meet(*claim, records, record.tolerance));
}

}  // namespace

std::optional<double> claim_of(const Record& record) {
  switch (record.status) {
    case DistanceStatus::optimal:
      return record.distance;
    case DistanceStatus::contains_origin:
      return 0;
    case DistanceStatus::unreachable:
      return kInfinity;
    default:
      return std::nullopt;
  }
}

bool is_solved(const Record& record) { return claim_of(record).has_value(); }

double time_or_infinity(const Record& record) { return is_solved(record) ? record.seconds : kInfinity; }

bool proofs_meet(const Record& a, const Record& b) { return meet(interval_of(a), interval_of(b)); }

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
    record.agrees = all_proofs_meet(record, records) && claim_holds(record, records, narrowest);
  }
}

}  // namespace raygauge
