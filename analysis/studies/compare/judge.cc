// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/judge.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/constants.h"
#include "analysis/statistics/randomisation_test.h"
#include "analysis/statistics/rank_tests.h"

namespace raygauge {
namespace {

/// Of finite values, about their mean; NaN with fewer than two.
double standard_deviation(const std::vector<double>& values, std::size_t first, std::size_t last) {
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (std::size_t i = first; i < last; ++i) {
    if (!std::isfinite(values[i])) continue;
    sum += values[i];
    ++count;
  }
  if (count < 2) return kNaN;
  for (std::size_t i = first; i < last; ++i)
    if (std::isfinite(values[i])) squares += (values[i] - sum / count) * (values[i] - sum / count);
  return std::sqrt(squares / (count - 1));
}

/// Standard deviation between runs: of a difference of two over √2, or the larger of the two sides'. NaN
/// without several runs.
double run_spread(const std::vector<double>& values, const Comparison& comparison) {
  if (values.empty()) return kNaN;
  if (comparison.options.paired) return standard_deviation(values, 0, values.size()) / std::sqrt(2.0);
  return std::fmax(standard_deviation(values, 0, comparison.base_runs),
                   standard_deviation(values, comparison.base_runs, values.size()));
}

/// The mean over a method's cells, run by run.
std::vector<double> method_values(const Comparison& comparison, const std::string& method) {
  std::vector<double> sums;
  std::vector<double> counts;
  for (const CellChange& cell : comparison.cells) {
    if (cell.method != method) continue;
    sums.resize(std::max(sums.size(), cell.run_values.size()));
    counts.resize(sums.size());
    for (std::size_t i = 0; i < cell.run_values.size(); ++i) {
      if (!std::isfinite(cell.run_values[i])) continue;
      sums[i] += cell.run_values[i];
      ++counts[i];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : kNaN;
  return sums;
}

/// Cells of one n and N run after each other: `compare --rerun` draws the order of a pair anew for each.
std::string block_of(const CellKey& cell) { return std::to_string(cell.n) + " " + std::to_string(cell.N); }

void test_between_runs(Comparison& comparison) {
  std::vector<RunSeries> series;
  std::vector<CellChange*> cells;
  for (CellChange& cell : comparison.cells) {
    cell.run_spread = run_spread(cell.run_values, comparison);
    if (cell.run_values.empty()) continue;
    series.push_back({block_of(cell.cell), cell.method, cell.run_values});
    cells.push_back(&cell);
  }
  std::vector<std::string> groups;
  for (MethodChange& method : comparison.methods) {
    groups.push_back(method.method);
    method.run_spread = run_spread(method_values(comparison, method.method), comparison);
  }
  if (series.empty()) return;
  const RandomisationResult result = comparison.options.paired
                                         ? test_pairs(series, groups)
                                         : test_runs(series, comparison.base_runs, groups);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i]->run_p = result.series[i];
  for (std::size_t i = 0; i < groups.size(); ++i) comparison.methods[i].run_p = result.groups[i];
}

/// One family of tests: every cell of every method, and every method as a whole.
void adjust_within_runs(Comparison& comparison) {
  std::vector<double> p_values;
  for (const CellChange& cell : comparison.cells) p_values.push_back(cell.ratio.p);
  for (const MethodChange& method : comparison.methods) p_values.push_back(method.ratio.p);
  const std::vector<double> adjusted = holm_adjusted(p_values);
  std::size_t i = 0;
  for (CellChange& cell : comparison.cells) cell.adjusted_p = adjusted[i++];
  for (MethodChange& method : comparison.methods) method.adjusted_p = adjusted[i++];
}

/// The smallest p value that so many runs can give a cell.
double smallest_run_p(const Comparison& comparison) {
  if (comparison.options.paired) return std::exp2(-static_cast<double>(comparison.base_runs));
  double p = 1;
  for (std::size_t i = 1; i <= comparison.base_runs; ++i)
    p *= static_cast<double>(i) / static_cast<double>(comparison.new_runs + i);
  return p;
}

/// Beyond the threshold, a change is one where runs of one build would hardly differ so much: by the test
/// between runs, or by all that was ever seen (`largest_drift`, of one run a side). What differs within runs
/// only is suspected, unless there are runs enough to know better.
Change verdict(const Finding& finding, double largest_drift, const Comparison& comparison) {
  const CompareOptions& options = comparison.options;
  const double ratio = finding.ratio.ratio.ratio;
  if (!beyond_threshold(ratio, options.threshold)) return Change::none;
  const bool slower = ratio > 1;
  const bool within = finding.adjusted_p < options.significance;
  const double runs =
      (1 / static_cast<double>(comparison.base_runs) + 1 / static_cast<double>(comparison.new_runs)) / 2;
  const bool beyond_drift = std::abs(std::log(ratio)) > std::sqrt(runs) * std::log(largest_drift);
  const bool runs_decide = smallest_run_p(comparison) <= options.significance;
  if (finding.run_p <= options.significance || (within && beyond_drift && !runs_decide))
    return slower ? Change::slower : Change::faster;
  if (!within || runs_decide) return Change::none;
  return slower ? Change::suspected_slower : Change::suspected_faster;
}

}  // namespace

const char* to_string(Change change) noexcept {
  switch (change) {
    case Change::none:
      return "none";
    case Change::faster:
      return "faster";
    case Change::slower:
      return "slower";
    case Change::suspected_faster:
      return "suspected faster";
    case Change::suspected_slower:
      break;
  }
  return "suspected slower";
}

bool beyond_threshold(double ratio, double threshold) {
  return std::abs(std::log(ratio)) > std::log1p(threshold);
}

void judge(Comparison& comparison) {
  adjust_within_runs(comparison);
  test_between_runs(comparison);
  for (CellChange& cell : comparison.cells) cell.change = verdict(cell, kLargestCellDrift, comparison);
  for (MethodChange& method : comparison.methods)
    method.change = verdict(method, kLargestMethodDrift, comparison);
}

}  // namespace raygauge
