// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/aggregate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>

#include "analysis/data/columns.h"
#include "analysis/data/outliers.h"
#include "analysis/statistics/statistics.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Values = std::vector<double>;

const std::map<std::string, std::function<double(const Values&)>>& functions() {
  static const std::map<std::string, std::function<double(const Values&)>> kFunctions = {
      {"median", [](const Values& values) { return median(values); }},
      {"mean", [](const Values& values) { return mean(values); }},
      {"share", [](const Values& values) { return mean(values); }},
      {"geomean", [](const Values& values) { return geometric_mean(values); }},
      {"min", [](const Values& values) { return quantile(values, 0); }},
      {"max", [](const Values& values) { return quantile(values, 1); }},
      {"sum", [](const Values& values) { return std::accumulate(values.begin(), values.end(), 0.0); }},
      {"q1", [](const Values& values) { return quantile(values, 0.25); }},
      {"q3", [](const Values& values) { return quantile(values, 0.75); }},
      {"outliers", [](const Values& values) { return static_cast<double>(outlier_count(values)); }}};
  return kFunctions;
}

/// The number behind a prefix: 10 for "sgm10".
std::optional<double> number_behind(std::string_view prefix, const std::string& name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  double number = 0;
  const char* end = name.data() + name.size();
  const auto [stop, failure] = std::from_chars(name.data() + prefix.size(), end, number);
  if (failure != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// 0.9 for "p90".
std::optional<double> percentile(const std::string& name) {
  const auto percent = number_behind("p", name);
  if (!percent || !(*percent >= 0 && *percent <= 100)) return std::nullopt;
  return *percent / 100;
}

/// 10 for "sgm10", the shift of a shifted geometric mean.
std::optional<double> shift_of(const std::string& name) {
  const auto shift = number_behind("sgm", name);
  if (!shift || !(*shift > 0 && std::isfinite(*shift))) return std::nullopt;
  return shift;
}

bool is_count(const std::string& name) {
  return name == "count" || name == "failures" || name == "disagreements";
}

void require_known(const std::string& name) {
  if (is_count(name) || functions().count(name) > 0 || percentile(name) || shift_of(name)) return;
  throw UnknownNameError("aggregate", name, aggregate_names());
}

}  // namespace

const std::vector<std::string>& aggregate_names() {
  static const std::vector<std::string> kNames = {
      "median", "mean",  "geomean", "sgm10",    "min", "max",           "sum",     "q1",
      "q3",     "share", "count",   "failures", "p90", "disagreements", "outliers"};
  return kNames;
}

Aggregate parse_aggregate(const std::string& text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t blank = std::min(text.find(' ', first), text.size());
  const std::size_t second = std::min(text.find_first_not_of(' ', blank), text.size());
  const std::size_t last = text.find_last_not_of(' ');
  Aggregate aggregate{text.substr(first, blank - first), ""};
  if (second < text.size()) aggregate.quantity = text.substr(second, last - second + 1);
  require_known(aggregate.name);
  if (is_count(aggregate.name)) {
    if (!aggregate.counts())
      throw InvalidParameterError("value '" + text + "': " + aggregate.name +
                                  " counts records; it takes no column");
    return aggregate;
  }
  if (aggregate.counts())
    throw InvalidParameterError("value '" + text + "' lacks a column, as in '" + aggregate.name +
                                " milliseconds'");
  if (aggregate.is_ratio() && !aggregate.is_share()) return aggregate;
  const AnalysisColumn* column = find_analysis_column(aggregate.quantity);
  if (column == nullptr) {
    std::vector<std::string> known = {"ratio"};
    for (const AnalysisColumn& each : analysis_columns()) known.push_back(each.name);
    throw UnknownNameError("column", aggregate.quantity, known, "value '" + text + "'");
  }
  if (aggregate.is_share() && column->type != ValueType::boolean)
    throw InvalidParameterError("value '" + text + "': a share is of a column of true and false, as in " +
                                "'share solved'");
  if (column->type == ValueType::text)
    throw InvalidParameterError("value '" + text + "': column '" + column->name +
                                "' holds texts, not numbers");
  aggregate.quantity = column->name;
  return aggregate;
}

double aggregate_of(const Aggregate& aggregate, const std::vector<double>& values) {
  if (const auto function = functions().find(aggregate.name); function != functions().end())
    return function->second(values);
  if (const auto order = percentile(aggregate.name)) return quantile(values, *order);
  if (const auto shift = shift_of(aggregate.name)) return shifted_geometric_mean(values, *shift);
  throw UnknownNameError("aggregate of values", aggregate.name, aggregate_names());
}

}  // namespace raygauge
