// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include "analysis/constants.h"
#include "analysis/studies/stability/stability.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

TableCell text(const std::string& words) { return {words, kNaN, Emphasis::none}; }

TableCell count(std::size_t number) {
  return {std::to_string(number), static_cast<double>(number), Emphasis::none};
}

TableCell alarming_count(std::size_t number) {
  TableCell cell = count(number);
  if (number > 0) cell.emphasis = Emphasis::alarm;
  return cell;
}

double certified_share(const StabilityRow& row) {
  return static_cast<double>(row.certified) / static_cast<double>(row.solves);
}

/// Per cent rounded down, so that 100 means every single one.
std::string per_cent(double share) {
  constexpr double kTenths = 1000;
  constexpr int kLength = 16;
  char buffer[kLength];
  std::snprintf(buffer, kLength, "%.1f", std::floor(kTenths * share) / 10);
  return std::string(share == 1 ? "100" : buffer) + " %";
}

TableCell width_cell(double width) {
  if (std::isinf(width)) return text("none");
  return text(padded_significant(width, 2));
}

TableCell error_cell(double error) {
  if (std::isnan(error)) return text("unknown");
  return text(padded_significant(error, 2));
}

TableCell time_cell(double seconds) {
  return text(std::isinf(seconds) ? "unsolved" : padded_significant(1e3 * seconds, 3));
}

TableRow reading_row(const StabilityRow& row, bool first) {
  const std::string family = row.family.empty() ? "all families" : row.family;
  TableRow line;
  line.starts_group = first;
  line.cells = {text(first ? family : ""),
                text(row.method),
                count(row.solves),
                text(per_cent(certified_share(row))),
                width_cell(row.worst_width),
                error_cell(row.worst_true_error),
                alarming_count(row.wrong),
                alarming_count(row.failures),
                time_cell(row.median_seconds)};
  return line;
}

std::vector<StabilityRow> all_rows(const StabilityTolerance& part) {
  std::vector<StabilityRow> rows = part.rows;
  rows.insert(rows.end(), part.totals.begin(), part.totals.end());
  return rows;
}

std::vector<std::string> notes_of(const StabilityTolerance& part) {
  const std::string tolerance = rounded_text(part.tolerance, 6);
  std::vector<std::string> notes = {
      "certified: solved with proven bounds of relative width at most " + tolerance +
          "; worst width: over all solves, none where a bound is missing",
      "wrong: an answer off by a relative error of more than " + rounded_text(10 * part.tolerance, 6) +
          ", or bounds that exclude the truth; failures: stopped at a limit without an answer",
      "a family is counted over all its parameters, n and N; --where chooses among them"};
  std::size_t solves = 0;
  std::size_t known = 0;
  for (const StabilityRow& row : part.totals) {
    solves += row.solves;
    known += row.truth_known;
  }
  if (known < solves)
    notes.push_back("the truth is unknown for " + std::to_string(solves - known) + " of " +
                    std::to_string(solves) + " solves, which therefore cannot be found wrong");
  return notes;
}

Table reading_table(const StabilityTolerance& part) {
  Table table;
  table.title = "Stability at tolerance " + rounded_text(part.tolerance, 6);
  table.key_columns = 2;
  table.header = {{"family", "method", "solves", "certified", "worst width", "worst true error", "wrong",
                   "failures", "median ms"}};
  std::string previous;
  for (const StabilityRow& row : all_rows(part)) {
    table.rows.push_back(reading_row(row, table.rows.empty() || row.family != previous));
    previous = row.family;
  }
  table.notes = notes_of(part);
  return table;
}

}  // namespace

std::vector<Table> stability_tables(const Stability& stability) {
  std::vector<Table> tables;
  for (const StabilityTolerance& part : stability) tables.push_back(reading_table(part));
  return tables;
}

Table stability_long_table(const Stability& stability) {
  Table table;
  table.title = "Stability";
  table.key_columns = 3;
  table.header = {{"tolerance", "family", "method", "solves", "certified", "certified_share", "worst_width",
                   "truth_known", "worst_true_error", "wrong", "failures", "median_milliseconds"}};
  for (const StabilityTolerance& part : stability) {
    for (const StabilityRow& row : all_rows(part)) {
      TableRow line;
      line.cells = {number_cell(part.tolerance),
                    text(row.family.empty() ? "all" : row.family),
                    text(row.method),
                    count(row.solves),
                    count(row.certified),
                    number_cell(certified_share(row)),
                    number_cell(row.worst_width),
                    count(row.truth_known),
                    number_cell(row.worst_true_error),
                    count(row.wrong),
                    count(row.failures),
                    number_cell(1e3 * row.median_seconds)};
      table.rows.push_back(std::move(line));
    }
  }
  return table;
}

}  // namespace raygauge
