// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/data/truth.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/sections.h"
#include "analysis/studies/stability/stability.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

std::size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    names.push_back(name);
    return names.size() - 1;
  }
  return static_cast<std::size_t>(found - names.begin());
}

/// The share of right answers of a method in a family.
HeatCell cell_of(const StabilityRow& row, double tolerance) {
  const std::size_t right = row.solves - std::min(row.solves, row.wrong + row.failures);
  HeatCell cell;
  cell.facets = {{"tolerance", rounded_text(tolerance, 3)}};
  cell.value = static_cast<double>(right) / static_cast<double>(row.solves);
  // Rounded down: 100 means every single one.
  cell.text = std::to_string(100 * right / row.solves) + " %";
  if (row.wrong > 0) cell.text += "!";
  cell.remark = std::to_string(right) + " of " + std::to_string(row.solves) + " solves right, " +
                std::to_string(row.wrong) + " wrong, " + std::to_string(row.failures) + " failed, " +
                std::to_string(row.certified) + " certified; worst error " +
                (std::isnan(row.worst_true_error) ? "unknown" : padded_significant(row.worst_true_error, 2)) +
                ", median time " + time_words(row.median_seconds);
  return cell;
}

HeatMap picture_of(const Stability& stability) {
  HeatMap map;
  map.caption =
      "Share of right answers: solved, and within 10 ε of the truth where it is known. \"!\": some "
      "answers are wrong, not only missing.";
  map.row_label = "family";
  map.column_label = "method";
  map.value_label = "share of right answers";
  map.logarithmic = false;
  for (const StabilityTolerance& part : stability) {
    for (const StabilityRow& row : part.rows) {
      HeatCell cell = cell_of(row, part.tolerance);
      cell.row = static_cast<double>(place_of(map.rows, row.family));
      cell.column = static_cast<double>(place_of(map.columns, row.method));
      map.cells.push_back(std::move(cell));
    }
  }
  return map;
}

/// The tables of many tolerances below each other.
Table one_table(const Stability& stability) {
  Table all;
  all.title = "Stability at " + std::to_string(stability.size()) + " tolerances";
  const std::vector<Table> tables = stability_tables(stability);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (i == 0) {
      all.header = tables[i].header;
      for (auto& line : all.header) line.insert(line.begin(), "tolerance");
      all.key_columns = tables[i].key_columns + 1;
    }
    const std::string tolerance = rounded_text(stability[i].tolerance, 3);
    for (TableRow row : tables[i].rows) {
      row.cells.insert(row.cells.begin(), TableCell(tolerance));
      all.rows.push_back(std::move(row));
    }
  }
  all.notes = {
      "certified: solved with proven bounds of relative width at most the tolerance; wrong: an answer off by "
      "more "
      "than 10 times the tolerance, or bounds that exclude the truth"};
  return all;
}

}  // namespace

std::optional<Section> stability_section(const Input& input) {
  const Stability& stability = input.stability;
  const bool known = std::any_of(stability.begin(), stability.end(), [](const StabilityTolerance& part) {
    return std::any_of(part.totals.begin(), part.totals.end(),
                       [](const StabilityRow& row) { return row.truth_known > 0; });
  });
  if (!known) return std::nullopt;
  Section section{"stability", "Stability", {}};
  section.blocks.emplace_back(picture_of(stability));
  constexpr std::size_t kMostTables = 2;
  if (stability.size() > kMostTables) {
    section.blocks.emplace_back(one_table(stability));
  } else {
    for (const Table& table : stability_tables(stability)) section.blocks.emplace_back(table);
  }
  return section;
}

}  // namespace raygauge::report
