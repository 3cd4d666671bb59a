// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <tuple>

#include "analysis/columns.h"
#include "analysis/number_text.h"
#include "analysis/report/blocks.h"
#include "analysis/report/sections/sections.h"
#include "analysis/truth.h"

namespace raygauge::report {
namespace {

struct AccuracyGroup {
  std::vector<double> errors;
  std::vector<double> seconds;
  std::vector<double> K;
  std::vector<double> N_rs;
};

using AccuracyKey = std::tuple<std::string, double, std::string>;  // problem, -tolerance, method

std::map<AccuracyKey, AccuracyGroup> accuracy_groups(const Input& input) {
  const Truth truth(input.all_records);
  std::map<AccuracyKey, AccuracyGroup> groups;
  for (const Record& record : input.records) {
    const double error = true_error(record, truth(record));
    if (!std::isfinite(error)) continue;
    AccuracyGroup& group =
        groups[{problem_facets(cell_key(record)).front().second, -record.tolerance, record.method}];
    group.errors.push_back(error);
    group.seconds.push_back(record.seconds);
    group.K.push_back(static_cast<double>(record.counters.outer_iterations));
    group.N_rs.push_back(static_cast<double>(record.counters.ray_iterations));
  }
  return groups;
}

}  // namespace

std::optional<Section> accuracy_section(const Input& input) {
  Table table;
  table.header = {{"problem", "ε", "method", "mean error", "largest error", "mean K", "mean N_rs",
                   "median time", "solves"}};
  table.key_columns = 3;
  std::string problem;
  for (const auto& [key, group] : accuracy_groups(input)) {
    const auto& [name, tolerance, method] = key;
    TableRow row{{{name},
                  {significant(-tolerance, 3)},
                  {method},
                  {padded_significant(mean(group.errors), 2)},
                  {padded_significant(quantile(group.errors, 1), 2)},
                  {padded_significant(mean(group.K), 3)},
                  {padded_significant(mean(group.N_rs), 3)},
                  {time_words(median(group.seconds))},
                  {std::to_string(group.errors.size())}},
                 problem != name && !problem.empty()};
    problem = name;
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) return std::nullopt;
  table.notes = {
      "error: |d - true d| / true d, absolute where the true d is 0; over solved records of known finite "
      "truth"};
  Section section{"accuracy", "Accuracy", {}};
  section.blocks.push_back(table_block(table));
  return section;
}

}  // namespace raygauge::report
