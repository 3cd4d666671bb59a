// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/record_groups.h"
#include "analysis/data/truth.h"
#include "analysis/render/table.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// How reliable one method is on one family at one tolerance ε.
struct StabilityRow {
  std::string family;  ///< name of the generator; "" over all of them
  std::string method;
  std::size_t solves = 0;
  std::size_t certified = 0;    ///< solved (is_solved()) with a relative width of the bounds of at most ε
  double worst_width = 0;       ///< largest (upper - lower) / upper; +∞ where a bound is missing
  std::size_t truth_known = 0;  ///< solves of which the true distance is known
  double worst_true_error = 0;  ///< largest true_error() of a solve that claims a distance; NaN without any
  std::size_t wrong = 0;        ///< is_wrong()
  std::size_t failures = 0;     ///< stopped at a limit: time, iterations or precision
  double median_seconds = 0;    ///< of a solve, failures counting as infinitely slow
};

/// The rows of one tolerance: by family, then method, each in order of first appearance.
struct StabilityTolerance {
  double tolerance = 0;
  std::vector<StabilityRow> rows;
  std::vector<StabilityRow> totals;  ///< one for each method, over all families
};

using Stability = std::vector<StabilityTolerance>;

/// Whether a solve gave a false answer or a false proof, given the true distance:
///   - its answer is off by a true_error() of more than 10 ε, or
///   - for methods that are no competitors, whatever their status: the truth lies outside [lower, upper] by
///   more than
///     its own rounding, truth_rounding().
/// A competitor's bounds are raygauge's own and not held against it; an answer is what a solved record
/// claims, so that one that stopped at a limit has none. False where the truth is unknown.
bool is_wrong(const Record& record, double truth);

/// Summarises the records that pass the filter. The truth may come from any record of the same instance,
/// whether it passes or not. Throws EmptySetError if none passes.
Stability make_stability(const std::vector<Record>& records, const Filter& filter = {});

/// Summarises all records.
Stability make_stability(const RecordGroups& records, const Truth& truth);

/// For reading: a table for each tolerance.
std::vector<Table> stability_tables(const Stability& stability);

/// For CSV: one row a tolerance, family and method; the family over all is "all".
Table stability_long_table(const Stability& stability);

}  // namespace raygauge
