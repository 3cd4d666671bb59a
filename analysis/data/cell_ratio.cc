// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/cell_ratio.h"

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
#include "analysis/data/pool.h"
#include "analysis/statistics/paired_ratio.h"
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
    const double seconds = center_of(times).seconds;
    if (std::isinf(seconds)) continue;
    const auto [place, first] = best_median.emplace(times.cell, seconds);
    if (!first && seconds >= place->second) continue;
    place->second = seconds;
    best[times.cell] = &times;
  }
  return best;
}

/// The ratio of two independent geometric means, its interval from theirs as in ratio_of_medians().
Ratio ratio_of_means(const Center& a, const Center& b) {
  const double ratio = a.seconds / b.seconds;
  if (!std::isfinite(ratio)) return {ratio, {0, kInfinity, a.interval.confidence}};
  const double down =
      std::hypot(std::log(a.seconds / a.interval.lower), std::log(b.interval.upper / b.seconds));
  const double up =
      std::hypot(std::log(a.interval.upper / a.seconds), std::log(b.seconds / b.interval.lower));
  return {ratio,
          {ratio * std::exp(-down), ratio * std::exp(up),
           std::min(a.interval.confidence, b.interval.confidence)}};
}

CellRatio ratio_to(const CellTimes& times, const CellTimes* baseline) {
  CellRatio result;
  result.times = times;
  const Center own = center_of(times);
  result.median_seconds = own.seconds;
  if (baseline == nullptr) {
    result.baseline_seconds = kNaN;
    result.ratio = {kNaN, {kNaN, kNaN, 0}};
    return result;
  }
  result.baseline = baseline->method;
  const Center of_baseline = center_of(*baseline);
  result.baseline_seconds = of_baseline.seconds;
  result.ratio = is_pool(times.cell) ? ratio_of_means(own, of_baseline)
                                     : ratio_of_medians(times.seconds, baseline->seconds);
  return result;
}

}  // namespace

Center center_of(const CellKey& cell, const std::vector<double>& seconds) {
  if (!is_pool(cell)) return {median(seconds), median_interval(seconds)};
  if (seconds.empty()) throw EmptySetError("geometric mean of no times");
  std::vector<double> logarithms;
  for (const double each : seconds)
    if (std::isfinite(each)) logarithms.push_back(std::log(each));
  if (2 * logarithms.size() <= seconds.size()) return {kInfinity, {kInfinity, kInfinity, 0}};
  const Ratio mean = geometric_mean_ratio(logarithms).ratio;
  if (logarithms.size() < 2) return {mean.ratio, {mean.ratio, mean.ratio, 0}};
  return {mean.ratio, mean.interval};
}

Center center_of(const CellTimes& times) { return center_of(times.cell, times.seconds); }

std::string center_words(const std::vector<CellKey>& cells) {
  const auto pools = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_pool));
  if (pools == 0) return "median";
  return pools == cells.size() ? "geometric mean" : "median (of own pairs: geometric mean)";
}

std::vector<CellTimes> cell_times(const RecordGroups& records) {
  std::map<std::tuple<CellKey, std::size_t, std::string>, CellTimes> cells;
  for (const RecordGroup& group : records) {
    const Record& first = group.first();
    CellTimes times{group.cell, first.method, first.method_parameters, {}};
    for (const Record* record : group.records) {
      if (!record->agrees) {
        ++times.disagreeing;
        continue;
      }
      times.seconds.push_back(time_or_infinity(*record));
      if (!is_solved(*record)) ++times.unsolved;
    }
    cells.emplace(std::tuple(group.cell, index_of(records.methods(), first.method), first.method_parameters),
                  std::move(times));
  }
  std::vector<CellTimes> result;
  result.reserve(cells.size());
  for (auto& [key, times] : cells) result.push_back(std::move(times));
  return result;
}

std::vector<CellRatio> cell_ratios(const std::vector<CellTimes>& numerators,
                                   const std::vector<CellTimes>& denominators,
                                   const std::vector<std::string>& baselines) {
  std::vector<CellTimes> baseline_times;
  std::copy_if(denominators.begin(), denominators.end(), std::back_inserter(baseline_times),
               [&](const CellTimes& times) { return contains(baselines, times.method); });
  const std::map<CellKey, const CellTimes*> best = best_baselines(baseline_times);
  std::vector<CellRatio> ratios;
  for (const CellTimes& times : numerators) {
    if (contains(baselines, times.method) || times.seconds.empty()) continue;
    const auto baseline = best.find(times.cell);
    ratios.push_back(ratio_to(times, baseline == best.end() ? nullptr : baseline->second));
  }
  return ratios;
}

std::vector<CellRatio> cell_ratios(const std::vector<Record>& records,
                                   const std::vector<Record>& baseline_records,
                                   const std::vector<std::string>& baselines) {
  return cell_ratios(cell_times(records), cell_times(baseline_records), baselines);
}

std::vector<std::string> default_baselines(const std::vector<Record>& records) {
  return default_baselines(methods_of(records));
}

std::vector<std::string> default_baselines(const MethodList& methods) {
  constexpr std::array<std::string_view, 2> kOfThePaper = {"glpk_primal", "glpk_dual"};
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

void require_baselines(const MethodList& methods, const std::vector<std::string>& baselines) {
  if (baselines.empty()) {
    throw InvalidParameterError(
        "a ratio needs a baseline, and no method here is one; name one with --baseline");
  }
  for (const std::string& baseline : baselines) {
    if (!contains(methods, baseline)) throw UnknownNameError("baseline", baseline, methods);
  }
}

std::vector<Record> baseline_records(const std::vector<Record>& all, const Filter& filter,
                                     const std::vector<std::string>& baselines) {
  require_baselines(methods_of(all), baselines);
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
