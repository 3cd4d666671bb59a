// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/data/columns.h"
#include "analysis/statistics/statistics.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// A method may miss its tolerance by this factor before its answer is called wrong: solvers have absolute
/// and relative tolerances of several kinds, and none of them promises ours.
constexpr double kAllowance = 10;

/// (upper - lower) / upper, and +∞ where one of the bounds says nothing.
double proven_width(const Record& record) {
  const double width = relative_gap(record);
  return std::isnan(width) ? kInfinity : width;
}

/// Gathers the records of one row.
class Tally {
 public:
  void add(const Record& record, double truth) {
    const double width = proven_width(record);
    const bool solved = is_solved(record);
    ++row_.solves;
    row_.certified += solved && width <= record.tolerance;
    row_.worst_width = std::max(row_.worst_width, width);
    row_.truth_known += !std::isnan(truth);
    row_.wrong += is_wrong(record, truth);
    row_.failures += !solved;
    seconds_.push_back(time_or_infinity(record));
    const double error = true_error(record, truth);
    if (!std::isnan(error)) worst_error_ = std::isnan(worst_error_) ? error : std::max(worst_error_, error);
  }

  StabilityRow row(const std::string& family, const std::string& method) const {
    StabilityRow row = row_;
    row.family = family;
    row.method = method;
    row.worst_true_error = worst_error_;
    row.median_seconds = median(seconds_);
    return row;
  }

 private:
  StabilityRow row_;
  double worst_error_ = kNaN;
  std::vector<double> seconds_;
};

/// Tallies by family and method.
using Tallies = std::map<std::pair<std::string, std::string>, Tally>;

std::vector<std::string> families_of(const RecordGroups& records) {
  std::vector<std::string> families;
  for (const RecordGroup& group : records) {
    if (std::find(families.begin(), families.end(), group.cell.generator) == families.end())
      families.push_back(group.cell.generator);
  }
  return families;
}

std::vector<StabilityRow> rows_of(const Tallies& tallies, const std::vector<std::string>& families,
                                  const std::vector<std::string>& methods) {
  std::vector<StabilityRow> rows;
  for (const std::string& family : families) {
    for (const std::string& method : methods) {
      const auto tally = tallies.find({family, method});
      if (tally != tallies.end()) rows.push_back(tally->second.row(family, method));
    }
  }
  return rows;
}

}  // namespace

bool is_wrong(const Record& record, double truth) {
  if (std::isnan(truth)) return false;
  if (true_error(record, truth) > kAllowance * record.tolerance) return true;
  const double slack = 1 - truth_rounding(record);
  // A bound that is NaN was never proven, and refutes nothing.
  return record.role == Role::engine && (truth < slack * record.lower || slack * truth > record.upper);
}

Stability make_stability(const std::vector<Record>& records, const Filter& filter) {
  const std::vector<Record> kept = filtered(records, filter);
  if (kept.empty())
    throw EmptySetError(records.empty() ? "no records"
                                        : "no record passes the filter '" + filter.expression() + "'");
  return make_stability(kept, Truth(records));
}

Stability make_stability(const RecordGroups& records, const Truth& truth) {
  std::map<double, Tallies> by_tolerance;
  for (const RecordGroup& group : records) {
    Tallies& tallies = by_tolerance[group.cell.tolerance];
    Tally& of_family = tallies[{group.cell.generator, group.first().method}];
    Tally& of_all = tallies[{"", group.first().method}];
    for (const Record* record : group.records) {
      const double distance = truth(*record);
      of_family.add(*record, distance);
      of_all.add(*record, distance);
    }
  }
  const std::vector<std::string> families = families_of(records);
  Stability stability;
  for (const auto& [tolerance, tallies] : by_tolerance) {
    stability.push_back({tolerance, rows_of(tallies, families, records.methods()),
                         rows_of(tallies, {""}, records.methods())});
  }
  return stability;
}

}  // namespace raygauge
