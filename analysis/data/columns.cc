// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/columns.h"

#include <algorithm>
#include <cmath>

#include "analysis/constants.h"
#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace {

double gap(const Record& record) { return record.lower == record.upper ? 0 : record.upper - record.lower; }

double error(const Record& record) {
  return record.distance == record.exact_distance ? 0 : std::abs(record.distance - record.exact_distance);
}

double relative_error(const Record& record) {
  const double absolute = error(record);
  return absolute == 0 ? 0 : absolute / std::abs(record.exact_distance);
}

AnalysisColumn stored(const Column<Record>& column) {
  AnalysisColumn result{static_cast<const ColumnInfo&>(column), column.get, {}, false};
  result.is_time = column.name == "seconds";
  return result;
}

AnalysisColumn derived(std::string name, std::string unit, std::string description,
                       double (*get)(const Record&), std::vector<std::string> aliases = {},
                       bool is_time = false) {
  return {{std::move(name), std::move(unit), std::move(description), ValueType::float64},
          [get](const Record& record) { return Value(get(record)); },
          std::move(aliases),
          is_time};
}

AnalysisColumn solved_column() {
  return {{"solved", "", "whether status is optimal, contains_origin or unreachable", ValueType::boolean},
          [](const Record& record) { return Value(is_solved(record)); },
          {},
          false};
}

AnalysisColumn renamed(const std::string& name, const std::string& original) {
  const auto& columns = record_columns();
  const auto source = std::find_if(columns.begin(), columns.end(),
                                   [&](const Column<Record>& column) { return column.name == original; });
  AnalysisColumn result = stored(*source);
  result.name = name;
  return result;
}

std::vector<AnalysisColumn> make_columns() {
  std::vector<AnalysisColumn> columns;
  for (const Column<Record>& column : record_columns()) columns.push_back(stored(column));
  columns.push_back(derived(
      "milliseconds", "ms", "1000 seconds", [](const Record& r) { return 1e3 * r.seconds; }, {"ms"}, true));
  columns.push_back(derived(
      "microseconds", "µs", "1000000 seconds", [](const Record& r) { return 1e6 * r.seconds; }, {"us"},
      true));
  columns.push_back(derived("load_milliseconds", "ms", "1000 load_seconds",
                            [](const Record& r) { return 1e3 * r.load_seconds; }));
  columns.push_back(derived("gap", "1", "upper - lower", gap));
  columns.push_back(derived("relative_gap", "1", "(upper - lower) / upper", relative_gap));
  columns.push_back(derived("error", "1", "|distance - exact_distance|", error));
  columns.push_back(
      derived("relative_error", "1", "|distance - exact_distance| / exact_distance", relative_error));
  columns.push_back(renamed("K", "outer_iterations"));
  columns.push_back(renamed("N_rs", "ray_iterations"));
  columns.push_back(solved_column());
  return columns;
}

struct ToNumber {
  double operator()(const std::string&) const { return kNaN; }
  template <class Number>
  double operator()(Number value) const {
    return static_cast<double>(value);
  }
};

struct ToText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return rounded_text(value, 6); }
  std::string operator()(const std::string& value) const { return value; }
  template <class Integer>
  std::string operator()(Integer value) const {
    return std::to_string(value);
  }
};

}  // namespace

const std::vector<AnalysisColumn>& analysis_columns() {
  static const std::vector<AnalysisColumn> kColumns = make_columns();
  return kColumns;
}

const AnalysisColumn* find_analysis_column(const std::string& name) {
  const auto& columns = analysis_columns();
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const AnalysisColumn& column) {
    return column.name == name ||
           std::find(column.aliases.begin(), column.aliases.end(), name) != column.aliases.end();
  });
  return found == columns.end() ? nullptr : &*found;
}

const AnalysisColumn& analysis_column(const std::string& name, const std::string& place) {
  if (const AnalysisColumn* column = find_analysis_column(name)) return *column;
  std::vector<std::string> known;
  for (const AnalysisColumn& column : analysis_columns()) known.push_back(column.name);
  throw UnknownNameError("column", name, known, place);
}

double relative_gap(const Record& record) {
  const double absolute = gap(record);
  return absolute == 0 ? 0 : absolute / record.upper;
}

double number_of(const AnalysisColumn& column, const Record& record) {
  if (column.type == ValueType::text)
    throw InvalidParameterError("column '" + column.name + "' holds texts; a number is needed");
  if (column.is_time && !is_solved(record)) return kInfinity;
  return std::visit(ToNumber{}, column.get(record));
}

std::string text_of(const Value& value) { return std::visit(ToText{}, value); }

}  // namespace raygauge
