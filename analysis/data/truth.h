// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// The true distances of instances: the generator's own where it knows one, else what an oracle (the method
/// `exact`) proved of the same instance, at whatever tolerance.
class Truth {
 public:
  explicit Truth(const std::vector<Record>& records);

  /// NaN where the truth is unknown.
  double operator()(const Record& record) const;

 private:
  using InstanceName = std::tuple<std::string, std::string, int, int, std::uint64_t, int>;
  static InstanceName name_of(const Record& record);
  std::map<InstanceName, double> proven_;
};

/// By how much of itself the truth of a record's instance may be off: what its generator says, and 0 where an
/// oracle proved it.
double truth_rounding(const Record& record);

/// The distance that a solved record claims: 0 for contains_origin, +∞ for unreachable; NaN for one that
/// stopped at a limit.
double claimed_distance(const Record& record);

/// |claim - truth| / truth; the absolute error where the truth is 0; 0 where both are infinite and +∞ where
/// one is. NaN for a record without a claim and for an unknown truth.
double true_error(const Record& record, double truth);

}  // namespace raygauge
