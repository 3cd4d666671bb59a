// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "analysis/data/instances.h"
#include "analysis/statistics/rank_tests.h"
#include "engine/exceptions.h"
#include "engine/sweep/agreement.h"

namespace raygauge {
namespace {

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

struct Pairs {
  std::vector<double> base;
  std::vector<double> fresh;
  std::size_t lost = 0;
  std::size_t contradictions = 0;
};

/// Records in disagreement are unanswered like unsolved ones: a new wrong answer is one lost.
Pairs pairs_of(const MethodInstances& base, const MethodInstances& fresh) {
  Pairs pairs;
  for (const auto& [old_record, new_record] : shared_instances(base, fresh)) {
    if (!proofs_meet(*old_record, *new_record)) ++pairs.contradictions;
    if (has_answer(*old_record) && !has_answer(*new_record)) ++pairs.lost;
    if (!has_answer(*old_record) && !has_answer(*new_record)) continue;
    pairs.base.push_back(answer_seconds(*old_record));
    pairs.fresh.push_back(answer_seconds(*new_record));
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

CellChange cell_change(const MethodInstances& base, const MethodInstances& fresh,
                       const CompareOptions& options, std::size_t& contradictions) {
  const std::vector<double> old_times = base.seconds();
  const std::vector<double> new_times = fresh.seconds();
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

std::vector<Record> passing_or_error(const std::vector<Record>& records, const Filter& filter,
                                     const std::string& run) {
  std::vector<Record> kept = filtered(records, filter);
  if (!kept.empty()) return kept;
  throw EmptySetError(records.empty()
                          ? run + " has no records"
                          : "no record of " + run + " passes the filter '" + filter.expression() + "'");
}

std::size_t count_of_methods(const std::map<CellKey, std::vector<MethodInstances>>& cells) {
  std::size_t count = 0;
  for (const auto& [cell, methods] : cells) count += methods.size();
  return count;
}

/// The changes of the methods that both runs have in a cell.
void compare_cell(const CellKey& cell, const std::vector<MethodInstances>& base,
                  const std::vector<MethodInstances>& fresh, Comparison& comparison) {
  for (const MethodInstances& before : base) {
    const auto after = std::find_if(fresh.begin(), fresh.end(), [&](const MethodInstances& each) {
      return each.method == before.method;
    });
    if (after == fresh.end()) continue;
    CellChange change = cell_change(before, *after, comparison.options, comparison.contradictions);
    change.cell = cell;
    change.method = before.method;
    comparison.cells.push_back(std::move(change));
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
  const std::vector<Record> old_records = passing_or_error(base, options.filter, options.base_name);
  const std::vector<Record> new_records = passing_or_error(fresh, options.filter, options.new_name);
  const auto old_cells = instances_by_cell(old_records);
  const auto new_cells = instances_by_cell(new_records);

  Comparison comparison;
  comparison.options = options;
  for (const auto& [cell, methods] : old_cells) {
    const auto found = new_cells.find(cell);
    if (found != new_cells.end()) compare_cell(cell, methods, found->second, comparison);
  }
  if (comparison.cells.empty())
    throw EmptySetError(options.base_name + " and " + options.new_name +
                        " have no cell (generator and its parameters, n, N, tolerance) and method in common");
  comparison.base_only = count_of_methods(old_cells) - comparison.cells.size();
  comparison.new_only = count_of_methods(new_cells) - comparison.cells.size();
  for (const std::string& method : methods_of(old_records)) {
    MethodChange change = method_change(method, comparison.cells, options);
    if (change.cells > 0) comparison.methods.push_back(std::move(change));
  }
  judge(comparison);
  return comparison;
}

}  // namespace raygauge
