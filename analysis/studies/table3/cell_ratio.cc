// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/cell_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "analysis/constants.h"
#include "analysis/data/columns.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::size_t index_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// What a method solves: one instance at one tolerance.
auto instance_key(const Record& record) {
  return std::make_tuple(cell_key(record), record.seed, record.repetition);
}

/// For each cell the baseline with the smallest median.
std::map<CellKey, const CellTimes*> best_baselines(const std::vector<CellTimes>& all) {
  std::map<CellKey, const CellTimes*> best;
  std::map<CellKey, double> best_median;
  for (const CellTimes& times : all) {
    if (times.seconds.empty()) continue;
    const double seconds = median(times.seconds);
    if (std::isinf(seconds)) continue;
    const auto [place, first] = best_median.emplace(times.cell, seconds);
    if (!first && seconds >= place->second) continue;
    place->second = seconds;
    best[times.cell] = &times;
  }
  return best;
}

CellRatio ratio_to(const CellTimes& times, const CellTimes* baseline) {
  CellRatio result;
  result.times = times;
  result.median_seconds = median(times.seconds);
  if (baseline == nullptr) {
    result.baseline_seconds = kNaN;
    result.ratio = {kNaN, {kNaN, kNaN, 0}};
    return result;
  }
  result.baseline = baseline->method;
  result.baseline_seconds = median(baseline->seconds);
  result.ratio = ratio_of_medians(times.seconds, baseline->seconds);
  return result;
}

}  // namespace

CellKey cell_key(const Record& record) {
  return {record.generator, record.generator_parameters, record.n, record.N, record.tolerance};
}

std::string problem_name(const CellKey& cell) {
  const std::string& parameters = cell.generator_parameters;
  return cell.generator + (parameters.empty() ? "" : " (" + parameters + ")");
}

std::vector<CellTimes> cell_times(const std::vector<Record>& records) {
  const std::vector<std::string> methods = methods_of(records);
  std::map<std::tuple<CellKey, std::size_t, std::string>, CellTimes> cells;
  for (const Record& record : records) {
    CellTimes& times = cells[{cell_key(record), index_of(methods, record.method), record.method_parameters}];
    times.cell = cell_key(record);
    times.method = record.method;
    times.method_parameters = record.method_parameters;
    if (!record.agrees) {
      ++times.disagreeing;
      continue;
    }
    times.seconds.push_back(time_or_infinity(record));
    if (!is_solved(record)) ++times.unsolved;
  }
  std::vector<CellTimes> result;
  result.reserve(cells.size());
  for (auto& [key, times] : cells) result.push_back(std::move(times));
  return result;
}

std::vector<CellRatio> cell_ratios(const std::vector<Record>& records,
                                   const std::vector<Record>& baseline_records,
                                   const std::vector<std::string>& baselines) {
  std::vector<Record> denominators;
  std::copy_if(baseline_records.begin(), baseline_records.end(), std::back_inserter(denominators),
               [&](const Record& record) { return contains(baselines, record.method); });
  const std::vector<CellTimes> baseline_times = cell_times(denominators);
  const std::map<CellKey, const CellTimes*> best = best_baselines(baseline_times);

  std::vector<CellRatio> ratios;
  for (const CellTimes& times : cell_times(records)) {
    if (contains(baselines, times.method) || times.seconds.empty()) continue;
    const auto baseline = best.find(times.cell);
    ratios.push_back(ratio_to(times, baseline == best.end() ? nullptr : baseline->second));
  }
  return ratios;
}

std::vector<std::string> default_baselines(const std::vector<Record>& records) {
  constexpr std::array<std::string_view, 2> kOfThePaper = {"glpk_primal", "glpk_dual"};
  const MethodList methods = methods_of(records);
  std::vector<std::string> of_the_paper;
  std::vector<std::string> all;
  for (const std::string& label : methods) {
    const MethodFacts& facts = *methods.find(label);
    if (facts.role != Role::baseline) continue;
    all.push_back(label);
    if (std::find(kOfThePaper.begin(), kOfThePaper.end(), facts.name) != kOfThePaper.end())
      of_the_paper.push_back(label);
  }
  return of_the_paper.empty() ? all : of_the_paper;
}

std::vector<Record> baseline_records(const std::vector<Record>& all, const Filter& filter,
                                     const std::vector<std::string>& baselines) {
  const std::vector<std::string> methods = methods_of(all);
  if (baselines.empty()) {
    throw InvalidParameterError(
        "a ratio needs a baseline, and no method here is one; name one with --baseline");
  }
  for (const std::string& baseline : baselines) {
    if (!contains(methods, baseline)) throw UnknownNameError("baseline", baseline, methods);
  }
  std::vector<Record> candidates;
  std::copy_if(all.begin(), all.end(), std::back_inserter(candidates),
               [&](const Record& record) { return contains(baselines, record.method); });
  // Not filtered(): a parameter that the filter names need not be one of the baselines'.
  std::vector<Record> passing;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(passing), filter);
  if (!passing.empty()) return passing;

  std::set<decltype(instance_key(all.front()))> instances;
  for (const Record& record : all) {
    if (filter(record)) instances.insert(instance_key(record));
  }
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(passing),
               [&](const Record& record) { return instances.count(instance_key(record)) > 0; });
  return passing;
}

}  // namespace raygauge
