// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/performance_profile/performance_profile.h"

#include <algorithm>
#include <map>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/instances.h"
#include "raygauge/exceptions.h"

namespace raygauge {
double ProfileCurve::rho(double tau) const {
  const auto within = std::upper_bound(ratios.begin(), ratios.end(), tau) - ratios.begin();
  return static_cast<double>(within) / static_cast<double>(instances);
}

std::vector<ProfileStep> ProfileCurve::steps(double last, std::size_t most) const {
  std::vector<ProfileStep> corners;
  const auto add = [&](double tau) { corners.push_back({tau, rho(tau)}); };
  add(1);
  const std::size_t stride = std::max<std::size_t>(1, ratios.size() / most);
  for (std::size_t i = stride - 1; i < ratios.size(); i += stride) add(ratios[i]);
  if (!ratios.empty()) add(ratios.back());
  add(last);
  return corners;
}

double profile_end(const std::vector<ProfileCurve>& curves) {
  constexpr double kMargin = 1.2;
  double end = 2;
  for (const ProfileCurve& curve : curves) {
    if (!curve.ratios.empty()) end = std::max(end, kMargin * curve.ratios.back());
  }
  return end;
}

std::vector<ProfileCurve> performance_profiles(const std::vector<Record>& records) {
  if (records.empty()) throw EmptySetError("performance profiles of no records");
  const auto by_cell = instances_by_cell(records);
  std::vector<const std::vector<MethodInstances>*> cells;
  for (const auto& [cell, instances] : by_cell) cells.push_back(&instances);
  return performance_profiles(cells, methods_of(records));
}

namespace {

/// Of each instance of a cell the shortest time that led to an answer, +infinity where none did; sorted.
std::vector<std::pair<MethodInstances::Instance, double>> fastest_times(
    const std::vector<MethodInstances>& methods) {
  std::vector<std::pair<MethodInstances::Instance, double>> all;
  for (const MethodInstances& method : methods)
    for (const auto& [instance, record] : method.records) all.emplace_back(instance, answer_seconds(*record));
  std::sort(all.begin(), all.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace

std::vector<ProfileCurve> performance_profiles(const std::vector<const std::vector<MethodInstances>*>& cells,
                                               const std::vector<std::string>& methods) {
  std::map<std::string, std::vector<double>> ratios;
  std::size_t count = 0;
  for (const std::vector<MethodInstances>* cell : cells) {
    const auto fastest = fastest_times(*cell);
    count += fastest.size();
    for (const MethodInstances& method : *cell) {
      std::vector<double>& own = ratios[method.method];
      auto least = fastest.begin();
      for (const auto& [instance, record] : method.records) {
        while (least->first != instance) ++least;
        if (has_answer(*record)) own.push_back(least->second > 0 ? record->seconds / least->second : 1);
      }
    }
  }
  std::vector<ProfileCurve> curves;
  for (const std::string& method : methods) {
    const auto found = ratios.find(method);
    if (found == ratios.end()) continue;
    std::sort(found->second.begin(), found->second.end());
    curves.push_back({method, std::move(found->second), count});
  }
  return curves;
}

}  // namespace raygauge
