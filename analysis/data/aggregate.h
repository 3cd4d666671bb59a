// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace raygauge {

/// What a table shows in a cell: an aggregate of a quantity, as in "median milliseconds".
struct Aggregate {
  std::string name;      ///< one of aggregate_names(); "p90": any quantile in per cent; "sgm10": any shift
  std::string quantity;  ///< a column, or "ratio"; "" for the counts

  /// "share": the part of all records for which a column of true and false is true, those that disagree
  /// included.
  bool is_share() const { return name == "share"; }
  /// "count", "failures" and "disagreements" count records, whatever their values.
  bool counts() const { return quantity.empty(); }
  bool is_ratio() const { return quantity == "ratio"; }
};

/// Splits "median milliseconds" or "count". Throws UnknownNameError for an unknown aggregate or quantity, and
/// InvalidParameterError where the quantity is missing, superfluous or a text.
Aggregate parse_aggregate(const std::string& text);

/// median, mean, geomean, sgm10, min, max, sum, q1, q3, outliers, share, count, failures, disagreements, p90.
const std::vector<std::string>& aggregate_names();

/// The aggregate of `values`, of which there is at least one and none is NaN.
double aggregate_of(const Aggregate& aggregate, const std::vector<double>& values);

}  // namespace raygauge
