// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare_tables.h"

#include <algorithm>
#include <cmath>

#include "analysis/render/number_text.h"

namespace raygauge {
namespace {

std::string ratio_words(const Ratio& ratio) {
  return std::isnan(ratio.ratio) ? "-"
                                 : interval_words(ratio.ratio, ratio.interval.lower, ratio.interval.upper);
}

std::string p_words(double p) {
  constexpr double kSmallest = 1e-4;
  return p < kSmallest ? "<1e-4" : significant(p, 2);
}

TableCell change_cell(Change change, std::size_t lost) {
  std::string text = change == Change::none ? "" : to_string(change);
  if (lost > 0) text += (text.empty() ? "" : ", ") + std::to_string(lost) + " lost";
  if (change == Change::slower || lost > 0) return {text, Emphasis::alarm};
  return {text, change == Change::faster ? Emphasis::strong : Emphasis::none};
}

Table methods_table(const Comparison& comparison) {
  Table table;
  table.title = "time of NEW over time of BASE, all cells";
  table.header = {{"method", "cells", "geometric mean", "adjusted p", ""}};
  for (const MethodChange& method : comparison.methods) {
    table.rows.push_back({{{method.method},
                           {std::to_string(method.cells)},
                           {ratio_words(method.ratio.ratio)},
                           {p_words(method.adjusted_p)},
                           change_cell(method.change, method.lost)}});
  }
  return table;
}

/// Cells with something to tell, the largest change first.
std::vector<CellChange> changed_cells(const Comparison& comparison) {
  std::vector<CellChange> changed;
  std::copy_if(comparison.cells.begin(), comparison.cells.end(), std::back_inserter(changed),
               [](const CellChange& cell) { return cell.change != Change::none || cell.lost > 0; });
  const auto rank = [](const CellChange& cell) {
    const double size = std::abs(std::log(cell.ratio.ratio.ratio));
    return std::pair(cell.lost > 0 ? 0 : (cell.change == Change::slower ? 1 : 2),
                     std::isnan(size) ? 0 : -size);
  };
  std::stable_sort(changed.begin(), changed.end(),
                   [&](const CellChange& a, const CellChange& b) { return rank(a) < rank(b); });
  return changed;
}

TableRow cell_row(const CellChange& cell) {
  constexpr double kMilli = 1e3;
  return {{{problem_name(cell.cell)},
           {cell.method},
           {std::to_string(cell.cell.n)},
           {std::to_string(cell.cell.N)},
           {significant(cell.cell.tolerance, 3)},
           {padded_significant(kMilli * cell.base_seconds, 3)},
           {padded_significant(kMilli * cell.new_seconds, 3)},
           {ratio_words(cell.ratio.ratio)},
           {p_words(cell.adjusted_p)},
           change_cell(cell.change, cell.lost)}};
}

Table cells_table(const Comparison& comparison, std::size_t most_rows) {
  const std::vector<CellChange> changed = changed_cells(comparison);
  Table table;
  table.title = "cells that changed: " + std::to_string(changed.size()) + " of " +
                std::to_string(comparison.cells.size());
  table.header = {{"generator (parameters)", "method", "n", "N", "tolerance", "base ms", "new ms", "ratio",
                   "adjusted p", ""}};
  table.key_columns = 5;
  for (const CellChange& cell : changed) {
    if (most_rows > 0 && table.rows.size() == most_rows) break;
    table.rows.push_back(cell_row(cell));
  }
  if (table.rows.size() < changed.size())
    table.notes.push_back(std::to_string(changed.size() - table.rows.size()) + " more; --all shows them");
  return table;
}

std::string percent_words(double fraction) { return significant(100 * fraction, 3) + " %"; }

std::vector<std::string> method_notes(const Comparison& comparison) {
  const std::size_t paired =
      static_cast<std::size_t>(std::count_if(comparison.cells.begin(), comparison.cells.end(),
                                             [](const CellChange& cell) { return cell.pairs > 0; }));
  const std::string level = percent_words(comparison.options.confidence);
  std::vector<std::string> notes;
  if (paired > 0) {
    notes.push_back("ratio: median of NEW / BASE over the instances that both ran, " + level +
                    " order-statistic interval, Wilcoxon's signed-rank test");
  }
  if (paired < comparison.cells.size()) {
    notes.push_back(std::to_string(comparison.cells.size() - paired) +
                    " cells without common instances: ratio of medians, " + level +
                    " interval from those of the medians, rank-sum test");
  }
  notes.push_back("geometric mean of the cells' ratios, " + level + " Student's t interval and test");
  notes.push_back(
      "p adjusted by Holm over " + std::to_string(comparison.cells.size() + comparison.methods.size()) +
      " tests; a change is significantly more than " + percent_words(comparison.options.threshold) +
      " with adjusted p < " + significant(comparison.options.significance, 3));
  return notes;
}

}  // namespace

std::vector<Table> comparison_tables(const Comparison& comparison, const std::vector<std::string>& warnings,
                                     std::size_t most_rows) {
  std::vector<Table> tables = {methods_table(comparison), cells_table(comparison, most_rows)};
  std::vector<std::string>& notes = tables.back().notes;
  for (std::string& note : method_notes(comparison)) notes.push_back(std::move(note));
  if (comparison.base_only + comparison.new_only > 0) {
    notes.push_back("only in BASE: " + std::to_string(comparison.base_only) +
                    " cells of a method; only in NEW: " + std::to_string(comparison.new_only));
  }
  for (const std::string& warning : warnings) notes.push_back("warning: " + warning);
  return tables;
}

Table comparison_long_table(const Comparison& comparison) {
  Table table;
  table.header = {{"generator", "generator_parameters", "n", "N", "tolerance", "method", "base_seconds",
                   "new_seconds", "pairs", "ratio", "lower", "upper", "p", "adjusted_p", "change", "lost"}};
  table.key_columns = 6;
  for (const CellChange& cell : comparison.cells) {
    const Interval& interval = cell.ratio.ratio.interval;
    table.rows.push_back({{{cell.cell.generator},
                           {cell.cell.generator_parameters},
                           {std::to_string(cell.cell.n)},
                           {std::to_string(cell.cell.N)},
                           number_cell(cell.cell.tolerance),
                           {cell.method},
                           number_cell(cell.base_seconds),
                           number_cell(cell.new_seconds),
                           {std::to_string(cell.pairs)},
                           number_cell(cell.ratio.ratio.ratio),
                           number_cell(interval.lower),
                           number_cell(interval.upper),
                           number_cell(cell.ratio.p),
                           number_cell(cell.adjusted_p),
                           {to_string(cell.change)},
                           {std::to_string(cell.lost)}}});
  }
  return table;
}

std::string comparison_verdict(const Comparison& comparison) {
  std::size_t slower = 0;
  std::size_t faster = 0;
  std::size_t lost = 0;
  for (const CellChange& cell : comparison.cells) {
    slower += cell.change == Change::slower ? 1 : 0;
    faster += cell.change == Change::faster ? 1 : 0;
    lost += cell.lost;
  }
  std::string methods;
  for (const MethodChange& method : comparison.methods) {
    if (method.change == Change::none) continue;
    methods += "; " + method.method + " " + to_string(method.change) + " over all cells";
  }
  std::string text = std::string(comparison.regressed() ? "REGRESSION" : "no regression") + ": of " +
                     std::to_string(comparison.cells.size()) + " cells " + std::to_string(slower) +
                     " slower, " + std::to_string(faster) + " faster" + methods;
  if (lost > 0) text += "; " + std::to_string(lost) + " instances no longer solved";
  if (comparison.contradictions > 0)
    text += "; " + std::to_string(comparison.contradictions) + " instances with contradictory bounds";
  return text;
}

}  // namespace raygauge
