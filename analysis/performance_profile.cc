// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/performance_profile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "analysis/cell_ratio.h"
#include "analysis/columns.h"
#include "analysis/constants.h"
#include "engine/exceptions.h"

namespace raygauge {
namespace {

using ProfileInstance = std::tuple<CellKey, std::uint64_t, int>;
using InstanceTimes = std::map<std::string, double>;  // by method

std::map<ProfileInstance, InstanceTimes> times_by_instance(const std::vector<Record>& records) {
  std::map<ProfileInstance, InstanceTimes> instances;
  for (const Record& record : records) {
    const double never = kInfinity;
    instances[{cell_key(record), record.seed, record.repetition}][record.method] =
        record.agrees ? time_or_infinity(record) : never;
  }
  return instances;
}

}  // namespace

double ProfileCurve::rho(double tau) const {
  const auto within = std::upper_bound(ratios.begin(), ratios.end(), tau) - ratios.begin();
  return static_cast<double>(within) / static_cast<double>(instances);
}

std::vector<ProfileCurve> performance_profiles(const std::vector<Record>& records) {
  if (records.empty()) throw EmptySetError("performance profiles of no records");
  const std::map<ProfileInstance, InstanceTimes> instances = times_by_instance(records);
  std::vector<ProfileCurve> curves;
  for (const std::string& method : methods_of(records)) {
    ProfileCurve curve{method, {}, instances.size()};
    for (const auto& [instance, times] : instances) {
      const auto own = times.find(method);
      if (own == times.end() || std::isinf(own->second)) continue;
      double fastest = own->second;
      for (const auto& [other, seconds] : times) fastest = std::min(fastest, seconds);
      curve.ratios.push_back(fastest > 0 ? own->second / fastest : 1);
    }
    std::sort(curve.ratios.begin(), curve.ratios.end());
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace raygauge
