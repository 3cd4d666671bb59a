// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/truth.h"

#include <cmath>

#include "analysis/constants.h"
#include "engine/sweep/agreement.h"

namespace raygauge {

Truth::Truth(const std::vector<Record>& records) {
  for (const Record& record : records) {
    if (record.role != Role::oracle) continue;
    const double claim = claimed_distance(record);
    if (!std::isnan(claim)) proven_.emplace(name_of(record), claim);
  }
}

double Truth::operator()(const Record& record) const {
  if (!std::isnan(record.exact_distance)) return record.exact_distance;
  const auto found = proven_.find(name_of(record));
  return found == proven_.end() ? kNaN : found->second;
}

Truth::InstanceName Truth::name_of(const Record& record) {
  return {record.generator, record.generator_parameters, record.n, record.N, record.seed, record.repetition};
}

double truth_rounding(const Record& record) {
  return std::isnan(record.exact_distance) ? 0 : record.exact_distance_rounding;
}

double claimed_distance(const Record& record) { return claim_of(record).value_or(kNaN); }

double true_error(const Record& record, double truth) {
  const double claim = claimed_distance(record);
  if (std::isnan(claim) || std::isnan(truth)) return kNaN;
  if (claim == truth) return 0;
  if (std::isinf(claim) || std::isinf(truth)) return kInfinity;
  const double error = std::abs(claim - truth);
  return truth == 0 ? error : error / truth;
}

}  // namespace raygauge
