// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/sweep/agreement.h"
#include "raygauge/sweep/record.h"
#include "results/schema/column.h"

namespace raygauge {

/// What a record can be filtered, grouped and aggregated by: a column of the results file, or a value derived
/// from several. ColumnInfo::description gives the formula.
struct AnalysisColumn : ColumnInfo {
  std::function<Value(const Record&)> get;
  std::vector<std::string> aliases;  ///< shorter names: "ms"
  bool is_time = false;              ///< a solve that did not succeed has no time: see time_or_infinity()
};

/// Every column: those of the file first, by the names they have there, then the derived ones.
const std::vector<AnalysisColumn>& analysis_columns();

/// The column of that name or alias. Throws UnknownNameError, which lists the known names; `place` says where
/// the name stood.
const AnalysisColumn& analysis_column(const std::string& name, const std::string& place = "");

/// The column of that name or alias, or nullptr.
const AnalysisColumn* find_analysis_column(const std::string& name);

/// (upper - lower) / upper; 0 where both bounds are equal (also both 0 or both infinite), NaN where either is
/// missing.
double relative_gap(const Record& record);

/// The value of a column as a number: booleans are 0 and 1, times of unsolved records +infinity. Throws
/// InvalidParameterError for a column of texts.
double number_of(const AnalysisColumn& column, const Record& record);

/// A value as short text: numbers with at most 6 significant digits ("1e-06" is written "1e-6"), booleans as
/// true and false.
std::string text_of(const Value& value);

}  // namespace raygauge
