// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/accuracy_tables.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/data/parameter_columns.h"
#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Nothing is averaged over parameters of the generator.
using GroupKey = std::tuple<std::string, std::string, int, int>;

GroupKey group_of(const Record& record) {
  return {record.generator, record.generator_parameters, record.n, record.N};
}

/// "example2, separation=3, n = 3, N = 200": parameters that differ between the records.
std::string name_of_group(const Record& record, const VaryingParameters& varying) {
  const std::string parameters = varying.of_generator(record);
  return record.generator + (parameters.empty() ? "" : ", " + parameters) +
         ", n = " + std::to_string(record.n) + ", N = " + std::to_string(record.N);
}

TableCell known_cell(double value, int digits) {
  if (std::isnan(value)) return {"unknown"};
  return padded_cell(value, digits);
}

TableCell gap_cell(double gap) {
  if (std::isinf(gap)) return {"none"};
  return known_cell(gap, 2);
}

TableCell flaw_cell(std::size_t count) {
  return {std::to_string(count), static_cast<double>(count), count == 0 ? Emphasis::none : Emphasis::alarm};
}

/// Time a digit from this tolerance to the next tighter one, in microseconds.
double next_digit(const AccuracyCurve& curve, std::size_t i) {
  if (i + 1 == curve.points.size()) return kNaN;
  const AccuracyPoint& here = curve.points[i];
  const AccuracyPoint& next = curve.points[i + 1];
  return 1e6 * (next.median_seconds - here.median_seconds) / std::log10(here.tolerance / next.tolerance);
}

Table group_table(const AccuracyGroup& group) {
  Table table;
  table.title = "Accuracy, " + group.name;
  table.key_columns = 2;
  table.header = {{"method", "ε", "error", "worst error", "gap", "worst gap", "median µs", "next digit µs",
                   "failed", "wrong"}};
  for (const AccuracyCurve& curve : group.curves) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const AccuracyPoint& point = curve.points[i];
      const double cost = next_digit(curve, i);
      TableRow row;
      row.starts_group = i == 0;
      row.cells = {{i == 0 ? curve.method : ""},
                   {rounded_text(point.tolerance, 6)},
                   known_cell(point.mean_relative_error, 2),
                   known_cell(point.largest_relative_error, 2),
                   gap_cell(point.mean_relative_gap),
                   gap_cell(point.largest_relative_gap),
                   known_cell(1e6 * point.median_seconds, 3),
                   padded_cell(cost, 2),
                   flaw_cell(point.failures),
                   flaw_cell(point.wrong)};
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

TableRow floor_row(const AccuracyGroup& group, const AccuracyCurve& curve, bool first) {
  const AccuracyFloor floor = accuracy_floor(curve);
  TableRow row;
  row.starts_group = first;
  row.cells = {
      {first ? group.name : ""},
      {curve.method},
      known_cell(floor.reached.mean_relative_error, 2),
      {rounded_text(floor.reached.tolerance, 6) + (floor.still_improving ? " (the last)" : "")},
      known_cell(1e6 * floor.reached.median_seconds, 3),
      padded_cell(1e6 * floor.seconds_a_digit, 2),
      std::isnan(floor.certified) ? TableCell("nowhere") : TableCell(rounded_text(floor.certified, 6))};
  return row;
}

Table floor_table(const std::vector<AccuracyGroup>& groups) {
  Table table;
  table.title = "Where each method stops getting better";
  table.key_columns = 2;
  table.header = {
      {"instances", "method", "error reached", "at ε", "median µs", "a digit µs", "certified to"}};
  for (const AccuracyGroup& group : groups) {
    for (const AccuracyCurve& curve : group.curves)
      table.rows.push_back(floor_row(group, curve, &curve == &group.curves.front()));
  }
  table.notes = {
      "errors and gaps are relative, and means over all solves but where they say worst; at ε: no tighter ε "
      "halves the "
      "error",
      "a digit: (median time at that ε - at the loosest) / decades between; certified to: the tightest ε at "
      "which every "
      "solve has a proven gap of at most ε"};
  return table;
}

}  // namespace

std::vector<AccuracyGroup> accuracy_groups(const RecordGroups& records, const Truth& truth) {
  std::vector<GroupKey> keys;
  std::map<GroupKey, std::vector<const Record*>> members;
  for (const RecordGroup& group : records) {
    if (group.first().role == Role::oracle) continue;
    const auto [place, is_new] = members.try_emplace(group_of(group.first()));
    if (is_new) keys.push_back(place->first);
    place->second.insert(place->second.end(), group.records.begin(), group.records.end());
  }
  const VaryingParameters varying(records);
  std::vector<AccuracyGroup> groups;
  for (const GroupKey& key : keys)
    groups.push_back({name_of_group(*members[key].front(), varying), accuracy_curves(members[key], truth)});
  return groups;
}

std::vector<AccuracyGroup> accuracy_groups(const std::vector<Record>& records, const Filter& filter) {
  const std::vector<Record> kept = filtered(records, filter);
  if (kept.empty()) {
    throw EmptySetError(records.empty() ? "accuracy of no records"
                                        : "no record passes the filter '" + filter.expression() + "'");
  }
  std::vector<AccuracyGroup> groups = accuracy_groups(kept, Truth(records));
  if (groups.empty())
    throw EmptySetError(
        "accuracy of the method exact alone: it is where truths come from, and is not judged");
  return groups;
}

std::vector<Table> accuracy_tables(const std::vector<AccuracyGroup>& groups) {
  std::vector<Table> tables;
  tables.reserve(groups.size() + 1);
  for (const AccuracyGroup& group : groups) tables.push_back(group_table(group));
  tables.push_back(floor_table(groups));
  return tables;
}

Table accuracy_long_table(const std::vector<AccuracyGroup>& groups) {
  Table table;
  table.title = "Accuracy";
  table.key_columns = 3;
  table.header = {{"instances", "method", "tolerance", "solves", "mean_relative_error",
                   "largest_relative_error", "mean_relative_gap", "largest_relative_gap",
                   "median_microseconds", "failed", "wrong", "beyond_gap"}};
  for (const AccuracyGroup& group : groups) {
    for (const AccuracyCurve& curve : group.curves) {
      for (const AccuracyPoint& point : curve.points) {
        TableRow row{{{group.name}, {curve.method}}, false};
        for (const double value :
             {point.tolerance, static_cast<double>(point.solves), point.mean_relative_error,
              point.largest_relative_error, point.mean_relative_gap, point.largest_relative_gap,
              1e6 * point.median_seconds, static_cast<double>(point.failures),
              static_cast<double>(point.wrong), static_cast<double>(point.beyond_gap)}) {
          row.cells.push_back(number_cell(value));
        }
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

}  // namespace raygauge
