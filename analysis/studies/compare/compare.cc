// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/instances.h"
#include "analysis/statistics/rank_tests.h"
#include "analysis/studies/compare/judge.h"
#include "engine/numerics/number_text.h"
#include "engine/sweep/agreement.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void require_compare_options(const Runs& base, const Runs& fresh, const CompareOptions& options) {
  if (!(options.threshold >= 0) || std::isinf(options.threshold)) {
    throw InvalidParameterError("threshold is " + rounded_text(options.threshold, 6) +
                                ", must be a number from 0 on");
  }
  for (const double level : {options.significance, options.confidence}) {
    if (!(level > 0 && level < 1))
      throw InvalidParameterError("significance and confidence must lie in (0, 1)");
  }
  if (base.empty() || fresh.empty()) throw EmptySetError("a comparison needs a run on either side");
  if (options.paired && base.size() != fresh.size())
    throw InvalidParameterError("pairs need as many runs of " + options.base_name + " as of " +
                                options.new_name);
}

/// One method in one cell: its records in each run of a side, null where a run lacks it.
struct Side {
  std::vector<const MethodInstances*> runs;

  /// The median over the runs of an instance's times; +infinity where half of them have no answer.
  std::vector<std::pair<std::pair<std::uint64_t, int>, double>> medians() const {
    std::map<std::pair<std::uint64_t, int>, std::vector<double>> times;
    for (const MethodInstances* run : runs) {
      if (run == nullptr) continue;
      for (const auto& [instance, record] : run->records) times[instance].push_back(answer_seconds(*record));
    }
    std::vector<std::pair<std::pair<std::uint64_t, int>, double>> result;
    for (const auto& [instance, seconds] : times) result.emplace_back(instance, median(seconds));
    return result;
  }
};

struct Pairs {
  std::vector<double> base;
  std::vector<double> fresh;
  std::size_t lost = 0;
};

/// The times of the instances that both sides have. Records in disagreement are unanswered like unsolved
/// ones: a new wrong answer is one lost.
Pairs pairs_of(const Side& base, const Side& fresh) {
  Pairs pairs;
  std::map<std::pair<std::uint64_t, int>, double> new_times;
  for (const auto& [instance, seconds] : fresh.medians()) new_times[instance] = seconds;
  for (const auto& [instance, seconds] : base.medians()) {
    const auto found = new_times.find(instance);
    if (found == new_times.end()) continue;
    if (std::isfinite(seconds) && std::isinf(found->second)) ++pairs.lost;
    if (std::isinf(seconds) && std::isinf(found->second)) continue;
    pairs.base.push_back(seconds);
    pairs.fresh.push_back(found->second);
  }
  return pairs;
}

/// Instances on which some run of one side excludes the answer of some run of the other.
std::size_t contradictions_of(const Side& base, const Side& fresh) {
  std::set<std::pair<std::uint64_t, int>> instances;
  for (const MethodInstances* before : base.runs) {
    for (const MethodInstances* after : fresh.runs) {
      if (before == nullptr || after == nullptr) continue;
      for (const auto& [old_record, new_record] : shared_instances(*before, *after))
        if (!proofs_meet(*old_record, *new_record))
          instances.insert({old_record->seed, old_record->repetition});
    }
  }
  return instances.size();
}

std::vector<double> all_seconds(const Side& side) {
  std::vector<double> result;
  for (const MethodInstances* run : side.runs) {
    if (run == nullptr) continue;
    const std::vector<double> seconds = run->seconds();
    result.insert(result.end(), seconds.begin(), seconds.end());
  }
  return result;
}

/// Median over the instances of both runs of log(second / first); NaN without any.
double log_ratio_of(const MethodInstances* first, const MethodInstances* second) {
  if (first == nullptr || second == nullptr) return kNaN;
  const Pairs pairs = pairs_of({{first}}, {{second}});
  return pairs.base.empty() ? kNaN : median(log_ratios(pairs.fresh, pairs.base));
}

/// One value a pair, or the level of each run, base's first: the median over its instances of its time over
/// the instance's median time in all runs.
std::vector<double> run_values_of(const Side& base, const Side& fresh, bool paired) {
  std::vector<double> values;
  if (paired) {
    for (std::size_t k = 0; k < base.runs.size(); ++k)
      values.push_back(log_ratio_of(base.runs[k], fresh.runs[k]));
    return values;
  }
  Side all = base;
  all.runs.insert(all.runs.end(), fresh.runs.begin(), fresh.runs.end());
  std::map<std::pair<std::uint64_t, int>, double> reference;
  for (const auto& [instance, seconds] : all.medians()) reference[instance] = seconds;
  for (const MethodInstances* run : all.runs) {
    std::vector<double> logs;
    if (run != nullptr) {
      for (const auto& [instance, record] : run->records)
        if (std::isfinite(reference[instance]))
          logs.push_back(std::log(answer_seconds(*record) / reference[instance]));
    }
    values.push_back(logs.empty() ? kNaN : median(logs));
  }
  return values;
}

std::vector<double> shifted(std::vector<double> values, double shift) {
  for (double& x : values) x -= shift;
  return values;
}

/// log(1 + threshold) with the sign of the change; nothing where the change is no larger.
std::optional<double> tested_shift(double ratio, double threshold) {
  const double change = std::log(ratio);
  if (!beyond_threshold(ratio, threshold)) return std::nullopt;
  return std::copysign(std::log1p(threshold), change);
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

/// The median of a pair's ratios over the pairs, or of new's levels over that of base's.
Ratio ratio_between_runs(const CellChange& change, std::size_t base_runs, const CompareOptions& options) {
  std::vector<double> logs;
  for (const double x : change.run_values)
    if (!std::isnan(x)) logs.push_back(x);
  if (options.paired) {
    if (logs.empty()) return {kNaN, {kNaN, kNaN, 0}};
    const Interval interval = median_interval(logs, options.confidence);
    return {std::exp(median(logs)),
            {std::exp(interval.lower), std::exp(interval.upper), interval.confidence}};
  }
  std::vector<double> base;
  std::vector<double> fresh;
  for (std::size_t i = 0; i < change.run_values.size(); ++i) {
    if (!std::isnan(change.run_values[i]))
      (i < base_runs ? base : fresh).push_back(std::exp(change.run_values[i]));
  }
  if (base.empty() || fresh.empty()) return {kNaN, {kNaN, kNaN, 0}};
  return ratio_of_medians(fresh, base, options.confidence);
}

CellChange cell_change(const Side& base, const Side& fresh, const CompareOptions& options) {
  const std::vector<double> old_times = all_seconds(base);
  const std::vector<double> new_times = all_seconds(fresh);
  CellChange change;
  change.base_count = old_times.size();
  change.new_count = new_times.size();
  change.base_seconds = median(old_times);
  change.new_seconds = median(new_times);
  change.medians = ratio_of_medians(new_times, old_times, options.confidence);
  const Pairs pairs = pairs_of(base, fresh);
  change.lost = pairs.lost;
  change.pairs = pairs.base.size();
  if (pairs.base.empty()) {
    change.ratio = {change.medians,
                    independent_p(new_times, old_times, change.medians.ratio, options.threshold)};
    return change;
  }
  change.ratio.ratio = paired_ratio(pairs.fresh, pairs.base, options.confidence);
  change.ratio.p = paired_p(log_ratios(pairs.fresh, pairs.base), change.ratio.ratio.ratio, options.threshold);
  if (base.runs.size() + fresh.runs.size() > 2) {
    change.run_values = run_values_of(base, fresh, options.paired);
    change.ratio.ratio = ratio_between_runs(change, base.runs.size(), options);
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

/// The records of one side that pass the filter, by cell, and what of them is where.
struct SideRecords {
  Runs runs;
  std::vector<std::map<CellKey, std::vector<MethodInstances>>> cells;
  std::map<CellKey, std::vector<std::string>> methods;
};

SideRecords side_records(const Runs& runs, const Filter& filter, const std::string& name) {
  SideRecords side;
  for (const std::vector<Record>& records : runs) {
    side.runs.push_back(filtered(records, filter));
    if (!side.runs.back().empty()) continue;
    throw EmptySetError(records.empty()
                            ? name + " has no records"
                            : "no record of " + name + " passes the filter '" + filter.expression() + "'");
  }
  for (const std::vector<Record>& records : side.runs) {
    side.cells.push_back(instances_by_cell(records));
    for (const auto& [cell, methods] : side.cells.back()) {
      std::vector<std::string>& known = side.methods[cell];
      for (const MethodInstances& each : methods)
        if (std::find(known.begin(), known.end(), each.method) == known.end()) known.push_back(each.method);
    }
  }
  return side;
}

Side side_of(const SideRecords& records, const CellKey& cell, const std::string& method) {
  Side side;
  for (const auto& run : records.cells) {
    const auto found = run.find(cell);
    side.runs.push_back(nullptr);
    if (found == run.end()) continue;
    for (const MethodInstances& each : found->second)
      if (each.method == method) side.runs.back() = &each;
  }
  return side;
}

std::size_t count_of_methods(const SideRecords& side) {
  std::size_t count = 0;
  for (const auto& [cell, methods] : side.methods) count += methods.size();
  return count;
}

/// The changes of the methods that both sides have in a cell.
void compare_cell(const CellKey& cell, const SideRecords& base, const SideRecords& fresh,
                  Comparison& comparison) {
  const auto after = fresh.methods.find(cell);
  if (after == fresh.methods.end()) return;
  for (const std::string& method : base.methods.at(cell)) {
    if (std::find(after->second.begin(), after->second.end(), method) == after->second.end()) continue;
    const Side before = side_of(base, cell, method);
    const Side now = side_of(fresh, cell, method);
    CellChange change = cell_change(before, now, comparison.options);
    comparison.contradictions += contradictions_of(before, now);
    change.cell = cell;
    change.method = method;
    comparison.cells.push_back(std::move(change));
  }
}

std::vector<std::string> methods_of_runs(const Runs& runs) {
  std::vector<std::string> methods;
  for (const std::vector<Record>& records : runs) {
    for (const std::string& method : methods_of(records))
      if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
  }
  return methods;
}

}  // namespace

bool Comparison::regressed() const {
  const auto worse = [](const Finding& entry) { return entry.change == Change::slower || entry.lost > 0; };
  return contradictions > 0 || std::any_of(cells.begin(), cells.end(), worse) ||
         std::any_of(methods.begin(), methods.end(), worse);
}

bool Comparison::suspicious() const {
  const auto suspected = [](const Finding& entry) { return entry.change == Change::suspected_slower; };
  return std::any_of(cells.begin(), cells.end(), suspected) ||
         std::any_of(methods.begin(), methods.end(), suspected);
}

Comparison compare_runs(const Runs& base, const Runs& fresh, const CompareOptions& options) {
  require_compare_options(base, fresh, options);
  const SideRecords old_records = side_records(base, options.filter, options.base_name);
  const SideRecords new_records = side_records(fresh, options.filter, options.new_name);
  Comparison comparison;
  comparison.options = options;
  comparison.base_runs = base.size();
  comparison.new_runs = fresh.size();
  for (const auto& [cell, methods] : old_records.methods)
    compare_cell(cell, old_records, new_records, comparison);
  if (comparison.cells.empty())
    throw EmptySetError(options.base_name + " and " + options.new_name +
                        " have no cell (generator and its parameters, n, N, tolerance) and method in common");
  comparison.base_only = count_of_methods(old_records) - comparison.cells.size();
  comparison.new_only = count_of_methods(new_records) - comparison.cells.size();
  for (const std::string& method : methods_of_runs(old_records.runs)) {
    MethodChange change = method_change(method, comparison.cells, options);
    if (change.cells > 0) comparison.methods.push_back(std::move(change));
  }
  judge(comparison);
  return comparison;
}

Comparison compare_runs(const std::vector<Record>& base, const std::vector<Record>& fresh,
                        const CompareOptions& options) {
  return compare_runs(Runs{base}, Runs{fresh}, options);
}

}  // namespace raygauge
