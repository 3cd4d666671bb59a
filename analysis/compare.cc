// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/columns.h"
#include "analysis/rank_tests.h"
#include "engine/exceptions.h"

namespace raygauge {
namespace {

using InstanceName = std::pair<std::uint64_t, int>;  // seed, repetition
using Group = std::map<InstanceName, const Record*>;
using Groups = std::map<std::pair<CellKey, std::size_t>, Group>;

void require_compare_options(const CompareOptions& options) {
  if (!(options.threshold >= 0) || std::isinf(options.threshold)) {
    throw InvalidParameterError("threshold is " + std::to_string(options.threshold) +
                                ", must be a number from 0 on");
  }
  for (const double level : {options.significance, options.confidence}) {
    if (!(level > 0 && level < 1))
      throw InvalidParameterError("significance and confidence must lie in (0, 1)");
  }
}

/// Records by cell and method; disagreeing ones are left out, as from every time.
Groups grouped(const std::vector<Record>& records, const std::vector<std::string>& methods,
               const Filter& filter) {
  Groups groups;
  for (const Record& record : records) {
    if (!record.agrees || !filter(record)) continue;
    const auto method = std::find(methods.begin(), methods.end(), record.method) - methods.begin();
    groups[{cell_key(record), static_cast<std::size_t>(method)}][{record.seed, record.repetition}] = &record;
  }
  return groups;
}

std::vector<double> times_of_group(const Group& group) {
  std::vector<double> seconds;
  for (const auto& [instance, record] : group) seconds.push_back(time_or_infinity(*record));
  return seconds;
}

/// Certified bounds that exclude each other by more than rounding: one of the runs is wrong.
bool contradict(const Record& a, const Record& b) {
  constexpr double kRounding = 1e-9;
  return a.upper < b.lower * (1 - kRounding) || b.upper < a.lower * (1 - kRounding);
}

struct Pairs {
  std::vector<double> base;
  std::vector<double> fresh;
  std::size_t lost = 0;
  std::size_t contradictions = 0;
};

Pairs pairs_of(const Group& base, const Group& fresh) {
  Pairs pairs;
  for (const auto& [instance, old_record] : base) {
    const auto found = fresh.find(instance);
    if (found == fresh.end()) continue;
    const Record& new_record = *found->second;
    if (contradict(*old_record, new_record)) ++pairs.contradictions;
    if (is_solved(*old_record) && !is_solved(new_record)) ++pairs.lost;
    if (!is_solved(*old_record) && !is_solved(new_record)) continue;
    pairs.base.push_back(time_or_infinity(*old_record));
    pairs.fresh.push_back(time_or_infinity(new_record));
  }
  return pairs;
}

/// log(1 + threshold) with the sign of the change; nothing where the change is no larger.
std::optional<double> tested_shift(double ratio, double threshold) {
  const double limit = std::log1p(threshold);
  const double change = std::log(ratio);
  if (!(std::abs(change) > limit)) return std::nullopt;
  return change > 0 ? limit : -limit;
}

std::vector<double> shifted(std::vector<double> values, double shift) {
  for (double& x : values) x -= shift;
  return values;
}

/// Two-sided p value of "the ratio is (1 + threshold)^±1", which is conservative for "it is no further from
/// 1".
double paired_p(const std::vector<double>& logarithms, double ratio, double threshold) {
  const std::optional<double> shift = tested_shift(ratio, threshold);
  return shift ? signed_rank_p(shifted(logarithms, *shift)) : 1;
}

double independent_p(std::vector<double> fresh, const std::vector<double>& base, double ratio,
                     double threshold) {
  const std::optional<double> shift = tested_shift(ratio, threshold);
  if (!shift) return 1;
  for (double& seconds : fresh) seconds /= std::exp(*shift);
  return rank_sum_p(fresh, base);
}

CellChange cell_change(const Group& base, const Group& fresh, const CompareOptions& options,
                       std::size_t& contradictions) {
  const std::vector<double> old_times = times_of_group(base);
  const std::vector<double> new_times = times_of_group(fresh);
  CellChange change;
  change.base_count = old_times.size();
  change.new_count = new_times.size();
  change.base_seconds = median(old_times);
  change.new_seconds = median(new_times);
  change.medians = ratio_of_medians(new_times, old_times, options.confidence);
  const Pairs pairs = pairs_of(base, fresh);
  contradictions += pairs.contradictions;
  change.lost = pairs.lost;
  change.pairs = pairs.base.size();
  if (pairs.base.empty()) {
    change.ratio = {change.medians,
                    independent_p(new_times, old_times, change.medians.ratio, options.threshold)};
  } else {
    change.ratio.ratio = paired_ratio(pairs.fresh, pairs.base, options.confidence);
    change.ratio.p =
        paired_p(log_ratios(pairs.fresh, pairs.base), change.ratio.ratio.ratio, options.threshold);
  }
  return change;
}

MethodChange method_change(const std::string& method, const std::vector<CellChange>& cells,
                           const CompareOptions& options) {
  MethodChange result;
  result.method = method;
  std::vector<double> logs;
  for (const CellChange& cell : cells) {
    if (cell.method != method) continue;
    ++result.cells;
    result.lost += cell.lost;
    if (!std::isnan(cell.ratio.ratio.ratio)) logs.push_back(std::log(cell.ratio.ratio.ratio));
  }
  result.ratio = geometric_mean_ratio(logs, options.confidence);
  const std::optional<double> shift = tested_shift(result.ratio.ratio.ratio, options.threshold);
  result.ratio.p = shift ? geometric_mean_ratio(shifted(logs, *shift)).p : 1;
  return result;
}

Change verdict(double ratio, double adjusted_p, const CompareOptions& options) {
  if (!(adjusted_p < options.significance)) return Change::none;
  if (ratio > 1 + options.threshold) return Change::slower;
  return ratio < 1 / (1 + options.threshold) ? Change::faster : Change::none;
}

/// One family of tests: every cell of every method, and every method as a whole.
void judge(Comparison& comparison) {
  std::vector<double> p_values;
  for (const CellChange& cell : comparison.cells) p_values.push_back(cell.ratio.p);
  for (const MethodChange& method : comparison.methods) p_values.push_back(method.ratio.p);
  const std::vector<double> adjusted = holm_adjusted(p_values);
  std::size_t i = 0;
  for (CellChange& cell : comparison.cells) {
    cell.adjusted_p = adjusted[i++];
    cell.change = verdict(cell.ratio.ratio.ratio, cell.adjusted_p, comparison.options);
  }
  for (MethodChange& method : comparison.methods) {
    method.adjusted_p = adjusted[i++];
    method.change = verdict(method.ratio.ratio.ratio, method.adjusted_p, comparison.options);
  }
}

}  // namespace

const char* to_string(Change change) noexcept {
  if (change == Change::none) return "none";
  return change == Change::faster ? "faster" : "slower";
}

bool Comparison::regressed() const {
  const auto worse = [](const auto& entry) { return entry.change == Change::slower || entry.lost > 0; };
  return contradictions > 0 || std::any_of(cells.begin(), cells.end(), worse) ||
         std::any_of(methods.begin(), methods.end(), worse);
}

Comparison compare_runs(const std::vector<Record>& base, const std::vector<Record>& fresh,
                        const CompareOptions& options) {
  require_compare_options(options);
  const std::vector<std::string> methods = methods_of(base);
  const Groups old_groups = grouped(base, methods, options.filter);
  std::vector<Record> known;
  std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(known), [&](const Record& record) {
    return std::find(methods.begin(), methods.end(), record.method) != methods.end();
  });
  const Groups new_groups = grouped(known, methods, options.filter);

  Comparison comparison;
  comparison.options = options;
  for (const auto& [key, group] : old_groups) {
    const auto found = new_groups.find(key);
    if (found == new_groups.end()) continue;
    CellChange change = cell_change(group, found->second, options, comparison.contradictions);
    change.cell = key.first;
    change.method = methods[key.second];
    comparison.cells.push_back(std::move(change));
  }
  if (comparison.cells.empty())
    throw EmptySetError("the two runs have no cell (generator, n, N, tolerance) and method in common");
  comparison.base_only = old_groups.size() - comparison.cells.size();
  comparison.new_only = grouped(fresh, methods_of(fresh), options.filter).size() - comparison.cells.size();
  for (const std::string& method : methods) {
    MethodChange change = method_change(method, comparison.cells, options);
    if (change.cells > 0) comparison.methods.push_back(std::move(change));
  }
  judge(comparison);
  return comparison;
}

}  // namespace raygauge
