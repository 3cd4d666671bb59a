// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/table3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/columns.h"
#include "analysis/statistics/statistics.h"
#include "analysis/studies/table3/paper.h"
#include "raygauge/exceptions.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

constexpr const char* kGenerator = "example2";

bool at_tolerance(const Record& record) {
  constexpr double kRounding = 1e-9;
  return std::abs(record.tolerance - paper::kTable3Tolerance) <= kRounding * paper::kTable3Tolerance;
}

template <class Predicate>
std::vector<Record> those(const std::vector<Record>& records, const Predicate& predicate) {
  std::vector<Record> result;
  std::copy_if(records.begin(), records.end(), std::back_inserter(result), predicate);
  return result;
}

/// The records that Table III is about.
std::vector<Record> example2_records(const std::vector<Record>& records) {
  std::vector<Record> result =
      those(records, [](const Record& record) { return record.generator == kGenerator; });
  if (result.empty()) result = records;
  result = those(result, at_tolerance);
  if (result.empty()) throw EmptySetError("Table III needs records at tolerance 1e-6; there are none");
  std::set<std::pair<std::string, std::string>> generators;
  for (const Record& record : result) generators.emplace(record.generator, record.generator_parameters);
  if (generators.size() == 1) return result;
  std::string known;
  for (const auto& [name, parameters] : generators)
    known += (known.empty() ? "" : "; ") + name + " " + parameters;
  throw InvalidParameterError("Table III needs instances of one generator, the records have several (" +
                              known + "); choose with --where");
}

void count_records(Table3Method& method, const std::vector<Record>& records) {
  method.largest_relative_gap = kNaN;
  for (const Record& record : records) {
    if (record.method != method.method) continue;
    ++method.records;
    if (!is_solved(record)) ++method.unsolved;
    if (!record.agrees) ++method.disagreeing;
    const double gap = relative_gap(record);
    if (!(gap <= record.tolerance)) ++method.above_tolerance;
    method.largest_relative_gap = std::fmax(method.largest_relative_gap, gap);
  }
}

double mean_of(const std::vector<double>& ratios) { return ratios.empty() ? kNaN : geometric_mean(ratios); }

void compare_with_paper(Table3Method& method) {
  std::vector<double> all;
  std::vector<double> ratios;
  std::vector<double> papers;
  for (const CellRatio& cell : method.cells) {
    if (std::isnan(cell.ratio.ratio)) continue;
    all.push_back(cell.ratio.ratio);
    const auto paper = paper::table3_cell(cell.times.cell.n, cell.times.cell.N);
    if (!paper) continue;
    ratios.push_back(cell.ratio.ratio);
    papers.push_back(paper->ratio);
    if (cell.ratio.ratio > paper->ratio / 2) method.above_half.push_back(cell);
  }
  method.compared = ratios.size();
  method.measured = all.size();
  method.geometric_mean = mean_of(all);
  method.compared_geometric_mean = mean_of(ratios);
  method.paper_geometric_mean = mean_of(papers);
}

}  // namespace

Table3 make_table3(const std::vector<Record>& records, const Filter& filter,
                   std::vector<std::string> baselines) {
  if (baselines.empty()) baselines = default_baselines(records);
  std::vector<Record> kept = filtered(records, filter);
  if (kept.empty()) {
    throw EmptySetError(records.empty() ? "Table III of no records"
                                        : "no record passes the filter '" + filter.expression() + "'");
  }
  kept = example2_records(kept);
  const std::vector<Record> denominators = baseline_records(records, filter, baselines);

  Table3 table3;
  table3.baselines = baselines;
  table3.records = kept.size();
  for (const Record& record : kept) table3.disagreeing += record.agrees ? 0 : 1;
  const std::vector<CellRatio> ratios = cell_ratios(kept, denominators, baselines);
  const MethodList methods = methods_of(kept);
  for (const std::string& name : methods) {
    const bool is_baseline = std::find(baselines.begin(), baselines.end(), name) != baselines.end();
    if (is_baseline || methods.is_competitor(name)) continue;
    Table3Method method;
    method.method = name;
    std::copy_if(ratios.begin(), ratios.end(), std::back_inserter(method.cells),
                 [&](const CellRatio& ratio) { return ratio.times.method == name; });
    count_records(method, kept);
    compare_with_paper(method);
    table3.methods.push_back(std::move(method));
  }
  if (table3.methods.empty())
    throw EmptySetError("Table III compares methods of raygauge with GLPK; the records have none of them");
  return table3;
}

}  // namespace raygauge
