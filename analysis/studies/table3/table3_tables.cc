// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/table3_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "analysis/constants.h"
#include "analysis/statistics/statistics.h"
#include "analysis/studies/table3/paper.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

std::string milliseconds_and_ratio(double milliseconds, double ratio, int time_digits) {
  if (std::isinf(milliseconds)) return "unsolved";
  return padded_significant(milliseconds, time_digits) +
         (std::isnan(ratio) ? "" : " (" + padded_significant(ratio, 2) + ")");
}

TableCell measured_cell(const CellRatio* cell) {
  if (cell == nullptr) return {};
  const auto paper = paper::table3_cell(cell->times.cell.n, cell->times.cell.N);
  const bool slow = paper && cell->ratio.ratio > paper->ratio / 2;
  const bool flawed = cell->times.unsolved > 0 || cell->times.disagreeing > 0;
  std::string text = milliseconds_and_ratio(1e3 * cell->median_seconds, cell->ratio.ratio, 3);
  if (slow) text += "*";
  if (flawed) text += "!";
  return {text, kNaN, slow || flawed ? Emphasis::alarm : Emphasis::none};
}

TableCell paper_cell(int n, int N) {
  const auto cell = paper::table3_cell(n, N);
  if (!cell) return {};
  constexpr int kLength = 32;
  char text[kLength];
  std::snprintf(text, kLength, "%.2f (%.2f)", cell->milliseconds, cell->ratio);
  return {text, Emphasis::muted};
}

std::string place(const CellRatio& cell) {
  return "n=" + std::to_string(cell.times.cell.n) + " N=" + std::to_string(cell.times.cell.N);
}

/// What the marks in a method's cells mean, and where they are.
std::vector<std::string> notes_of(const Table3Method& method) {
  std::vector<std::string> notes;
  std::vector<std::string> slow;
  for (const CellRatio& cell : method.above_half) slow.push_back(place(cell));
  if (!slow.empty()) notes.push_back("* more than half of the paper's ratio: " + joined(slow, ", "));
  std::vector<std::string> flawed;
  for (const CellRatio& cell : method.cells) {
    if (cell.times.unsolved > 0)
      flawed.push_back(place(cell) + " " + std::to_string(cell.times.unsolved) + " unsolved");
    if (cell.times.disagreeing > 0)
      flawed.push_back(place(cell) + " " + std::to_string(cell.times.disagreeing) + " in disagreement");
  }
  if (!flawed.empty()) {
    notes.push_back("! unsolved solves count as infinitely slow, disagreeing ones are left out: " +
                    joined(flawed, ", "));
  }
  return notes;
}

Table layout_table(const Table3& table3, const Table3Method& method) {
  std::set<int> dimensions;
  std::set<int> sizes;
  std::map<std::pair<int, int>, const CellRatio*> cells;
  for (const CellRatio& cell : method.cells) {
    dimensions.insert(cell.times.cell.n);
    sizes.insert(cell.times.cell.N);
    cells[{cell.times.cell.n, cell.times.cell.N}] = &cell;
  }
  Table table;
  table.title = "Table III, " + method.method + ": median ms of a solve (ratio to the better of " +
                joined(table3.baselines, ", ") + ")";
  table.key_columns = 2;
  table.header = {{"", ""}};
  for (const int N : sizes) table.header[0].push_back((N == *sizes.begin() ? "N=" : "") + std::to_string(N));
  for (const int n : dimensions) {
    TableRow ours{{{"n=" + std::to_string(n)}, {"measured"}}, true};
    TableRow paper{{{""}, {"paper", Emphasis::muted}}, false};
    for (const int N : sizes) {
      const auto found = cells.find({n, N});
      ours.cells.push_back(measured_cell(found == cells.end() ? nullptr : found->second));
      paper.cells.push_back(paper_cell(n, N));
    }
    table.rows.push_back(std::move(ours));
    if (method.compared > 0) table.rows.push_back(std::move(paper));
  }
  table.notes = notes_of(method);
  return table;
}

const CellRatio* worst_cell(const Table3Method& method) {
  const CellRatio* worst = nullptr;
  for (const CellRatio& cell : method.cells) {
    if (!std::isnan(cell.ratio.ratio) && (worst == nullptr || cell.ratio.ratio > worst->ratio.ratio))
      worst = &cell;
  }
  return worst;
}

std::string verdict(const Table3& table3) {
  const std::string all = counted(table3.records, "record");
  if (table3.disagreeing == 0) return "agreement: all " + all + " agree, baselines included";
  return "agreement: " + std::to_string(table3.disagreeing) + " of " + all +
         " DISAGREE with another method; their times are left out";
}

TableCell ratio_cell(double ratio) {
  if (std::isnan(ratio)) return {"none", Emphasis::alarm};
  return {padded_significant(ratio, 3), ratio, Emphasis::strong};
}

TableCell count_cell(std::size_t count, std::size_t total) {
  return {std::to_string(count) + " of " + std::to_string(total), kNaN,
          count == 0 ? Emphasis::none : Emphasis::alarm};
}

bool has_cells_of_the_paper(const Table3& table3) {
  return std::any_of(table3.methods.begin(), table3.methods.end(),
                     [](const Table3Method& method) { return method.compared > 0; });
}

/// Where the grid is not the paper's, only the cells that both have are compared.
void add_paper_rows(Table& table, const Table3& table3) {
  const auto row = [&](const std::string& what, const auto& cell_of) {
    add_summary_row(table, what, table3.methods, cell_of);
  };
  const bool own_grid = std::any_of(table3.methods.begin(), table3.methods.end(),
                                    [](const Table3Method& m) { return m.compared < m.measured; });
  if (own_grid) {
    row("in the cells of the paper", [](const Table3Method& m) {
      TableCell cell = ratio_cell(m.compared_geometric_mean);
      cell.text += " (" + std::to_string(m.compared) + ")";
      return cell;
    });
  }
  row("the paper's, same cells", [](const Table3Method& m) {
    TableCell cell = ratio_cell(m.paper_geometric_mean);
    cell.emphasis = Emphasis::muted;
    return cell;
  });
}

Table summary_of(const Table3& table3) {
  Table table = summary_table("Table III, summary", table3.methods,
                              [](const Table3Method& method) { return method.method; });
  const auto row = [&](const std::string& what, const auto& cell_of) {
    add_summary_row(table, what, table3.methods, cell_of);
  };
  row("cells", [](const Table3Method& m) { return TableCell{std::to_string(m.cells.size())}; });
  row("geometric mean of the ratios", [](const Table3Method& m) { return ratio_cell(m.geometric_mean); });
  if (has_cells_of_the_paper(table3)) add_paper_rows(table, table3);
  row("worst cell", [](const Table3Method& m) {
    const CellRatio* worst = worst_cell(m);
    if (worst == nullptr) return ratio_cell(kNaN);
    return TableCell{padded_significant(worst->ratio.ratio, 3) + " at " + place(*worst), Emphasis::none};
  });
  if (has_cells_of_the_paper(table3))
    row("cells above half the paper's ratio",
        [](const Table3Method& m) { return count_cell(m.above_half.size(), m.compared); });
  row("largest certified relative gap", [](const Table3Method& m) {
    if (std::isnan(m.largest_relative_gap)) return ratio_cell(kNaN);
    return TableCell{padded_significant(m.largest_relative_gap, 2), m.largest_relative_gap, Emphasis::none};
  });
  row("records not certified to 1e-6",
      [](const Table3Method& m) { return count_cell(m.above_tolerance, m.records); });
  row("records unsolved", [](const Table3Method& m) { return count_cell(m.unsolved, m.records); });
  row("records in disagreement", [](const Table3Method& m) { return count_cell(m.disagreeing, m.records); });
  table.notes.push_back(verdict(table3));
  return table;
}

}  // namespace

std::vector<Table> table3_tables(const Table3& table3) {
  std::vector<Table> tables;
  for (const Table3Method& method : table3.methods) tables.push_back(layout_table(table3, method));
  tables.push_back(summary_of(table3));
  return tables;
}

Table table3_long_table(const Table3& table3) {
  Table table;
  table.title = "Table III";
  table.key_columns = 3;
  table.header = {{"method", "n", "N", "milliseconds", "ratio", "ratio_lower", "ratio_upper", "baseline",
                   "baseline_milliseconds", "paper_milliseconds", "paper_ratio", "records", "unsolved",
                   "disagreeing"}};
  for (const Table3Method& method : table3.methods) {
    for (const CellRatio& cell : method.cells) {
      const auto& [key, name, parameters, seconds, unsolved, disagreeing] = cell.times;
      const auto paper = paper::table3_cell(key.n, key.N);
      TableRow row;
      row.cells = {{name},
                   number_cell(key.n),
                   number_cell(key.N),
                   number_cell(1e3 * cell.median_seconds),
                   number_cell(cell.ratio.ratio),
                   number_cell(cell.ratio.interval.lower),
                   number_cell(cell.ratio.interval.upper),
                   {cell.baseline},
                   number_cell(1e3 * cell.baseline_seconds),
                   number_cell(paper ? paper->milliseconds : kNaN),
                   number_cell(paper ? paper->ratio : kNaN),
                   number_cell(static_cast<double>(seconds.size() + disagreeing)),
                   number_cell(static_cast<double>(unsolved)),
                   number_cell(static_cast<double>(disagreeing))};
      table.rows.push_back(std::move(row));
    }
  }
  table.notes.push_back(verdict(table3));
  return table;
}

}  // namespace raygauge
