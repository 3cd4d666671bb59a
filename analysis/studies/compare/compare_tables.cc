// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

std::string ratio_words(const Ratio& ratio) {
  return std::isnan(ratio.ratio) ? "-"
                                 : interval_words(ratio.ratio, ratio.interval.lower, ratio.interval.upper);
}

std::string p_words(double p) {
  constexpr double kSmallest = 1e-4;
  return p < kSmallest ? "<1e-4" : rounded_text(p, 2);
}

TableCell change_cell(const Finding& finding) {
  std::string text = finding.change == Change::none ? "" : to_string(finding.change);
  if (finding.lost > 0) text += (text.empty() ? "" : ", ") + std::to_string(finding.lost) + " lost";
  if (finding.change == Change::slower || finding.lost > 0) return {text, Emphasis::alarm};
  return {text, finding.change == Change::none ? Emphasis::none : Emphasis::strong};
}

bool has_several_runs(const Comparison& comparison) { return comparison.base_runs + comparison.new_runs > 2; }

/// What the verdict rests on: the p value between runs where there are several a side.
TableCell p_cell(const Finding& finding, const Comparison& comparison) {
  return p_words(has_several_runs(comparison) ? finding.run_p : finding.adjusted_p);
}

TableCell spread_cell(const Finding& finding) {
  return std::isnan(finding.run_spread) ? "-" : rounded_text(100 * finding.run_spread, 2) + " %";
}

Table methods_table(const Comparison& comparison) {
  Table table;
  table.title = "time of NEW over time of BASE, all cells";
  table.header = {{"method", "cells", "geometric mean", "between runs", "adjusted p", ""}};
  for (const MethodChange& method : comparison.methods) {
    table.rows.push_back({{{method.method},
                           {std::to_string(method.cells)},
                           {ratio_words(method.ratio.ratio)},
                           spread_cell(method),
                           p_cell(method, comparison),
                           change_cell(method)}});
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
    const bool slower = cell.change == Change::slower || cell.change == Change::suspected_slower;
    return std::pair(cell.lost > 0 ? 0 : (slower ? 1 : 2), std::isnan(size) ? 0 : -size);
  };
  std::stable_sort(changed.begin(), changed.end(),
                   [&](const CellChange& a, const CellChange& b) { return rank(a) < rank(b); });
  return changed;
}

TableRow cell_row(const CellChange& cell, const Comparison& comparison) {
  constexpr double kMilli = 1e3;
  return {{{problem_name(cell.cell)},
           {cell.method},
           {std::to_string(cell.cell.n)},
           {std::to_string(cell.cell.N)},
           {rounded_text(cell.cell.tolerance, 3)},
           {padded_significant(kMilli * cell.base_seconds, 3)},
           {padded_significant(kMilli * cell.new_seconds, 3)},
           {ratio_words(cell.ratio.ratio)},
           spread_cell(cell),
           p_cell(cell, comparison),
           change_cell(cell)}};
}

Table cells_table(const Comparison& comparison, std::size_t most_rows) {
  const std::vector<CellChange> changed = changed_cells(comparison);
  Table table;
  table.title = "cells that changed: " + std::to_string(changed.size()) + " of " +
                std::to_string(comparison.cells.size());
  table.header = {{"generator (parameters)", "method", "n", "N", "tolerance", "base ms", "new ms", "ratio",
                   "between runs", "adjusted p", ""}};
  table.key_columns = 5;
  for (const CellChange& cell : changed) {
    if (most_rows > 0 && table.rows.size() == most_rows) break;
    table.rows.push_back(cell_row(cell, comparison));
  }
  if (table.rows.size() < changed.size())
    table.notes.push_back(std::to_string(changed.size() - table.rows.size()) + " more; --all shows them");
  return table;
}

std::string percent_words(double fraction) { return rounded_text(100 * fraction, 3) + " %"; }

std::string threshold_words(const Comparison& comparison) {
  return percent_words(comparison.options.threshold) + " with adjusted p ";
}

/// The tests within runs: all there is with one run a side.
std::vector<std::string> notes_within_runs(const Comparison& comparison) {
  const auto paired =
      static_cast<std::size_t>(std::count_if(comparison.cells.begin(), comparison.cells.end(),
                                             [](const CellChange& cell) { return cell.pairs > 0; }));
  const std::string level = percent_words(comparison.options.confidence);
  std::vector<std::string> notes;
  if (paired > 0) {
    notes.push_back("ratio: median of NEW / BASE over the instances that both ran, " + level +
                    " order-statistic interval, Wilcoxon's signed-rank test");
  }
  if (paired < comparison.cells.size()) {
    notes.push_back(counted(comparison.cells.size() - paired, "cell") +
                    " without common instances: ratio of medians, " + level +
                    " interval from those of the medians, rank-sum test");
  }
  notes.push_back("geometric mean of the cells' ratios, " + level + " Student's t interval and test");
  notes.push_back("p adjusted by Holm over " +
                  counted(comparison.cells.size() + comparison.methods.size(), "test") +
                  "; a difference within the runs is one of more than " + threshold_words(comparison) + "< " +
                  rounded_text(comparison.options.significance, 3));
  notes.push_back(
      "one run a side does not tell how runs differ: such a difference is suspected, and a change "
      "only beyond a factor of " +
      rounded_text(kLargestCellDrift, 3) + " in a cell or " + rounded_text(kLargestMethodDrift, 3) +
      " of a method, the most that a busy machine was seen to drift; compare --rerun or several "
      "files a side decide");
  return notes;
}

std::vector<std::string> notes_between_runs(const Comparison& comparison) {
  const std::string runs = comparison.options.paired
                               ? counted(comparison.base_runs, "pair") + " of runs, each in random order"
                               : counted(comparison.base_runs, "run") + " of BASE, " +
                                     counted(comparison.new_runs, "run") + " of NEW";
  return {runs + "; ratio: median over them of the instances' median ratio, with its range or interval",
          "between runs: standard deviation of a run's log time, in per cent",
          std::string("adjusted p: randomisation test of the ") +
              (comparison.options.paired ? "signs of the pairs" : "labels of the runs") +
              " by the largest statistic over all cells and methods; a change is one of more than " +
              threshold_words(comparison) + "<= " + rounded_text(comparison.options.significance, 3)};
}

std::vector<std::string> method_notes(const Comparison& comparison) {
  return has_several_runs(comparison) ? notes_between_runs(comparison) : notes_within_runs(comparison);
}

}  // namespace

std::vector<Table> comparison_tables(const Comparison& comparison, const std::vector<std::string>& warnings,
                                     std::size_t most_rows) {
  std::vector<Table> tables = {methods_table(comparison), cells_table(comparison, most_rows)};
  std::vector<std::string>& notes = tables.back().notes;
  for (std::string& note : method_notes(comparison)) notes.push_back(std::move(note));
  if (comparison.base_only + comparison.new_only > 0) {
    notes.push_back("only in BASE: " + counted(comparison.base_only, "cell") +
                    " of a method; only in NEW: " + std::to_string(comparison.new_only));
  }
  for (const std::string& warning : warnings) notes.push_back("warning: " + warning);
  return tables;
}

Table comparison_long_table(const Comparison& comparison) {
  Table table;
  table.header = {{"generator", "generator_parameters", "n", "N", "tolerance", "method", "base_seconds",
                   "new_seconds", "pairs", "ratio", "lower", "upper", "p", "adjusted_p", "run_p",
                   "run_spread", "change", "lost"}};
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
                           number_cell(cell.run_p),
                           number_cell(cell.run_spread),
                           {to_string(cell.change)},
                           {std::to_string(cell.lost)}}});
  }
  return table;
}

std::string comparison_verdict(const Comparison& comparison) {
  std::array<std::size_t, 5> counts{};
  std::size_t lost = 0;
  for (const CellChange& cell : comparison.cells) {
    ++counts.at(static_cast<std::size_t>(cell.change));
    lost += cell.lost;
  }
  std::string text = comparison.regressed()    ? "REGRESSION"
                     : comparison.suspicious() ? "suspected regression"
                                               : "no regression";
  text += ": of " + counted(comparison.cells.size(), "cell") + " " +
          std::to_string(counts[static_cast<std::size_t>(Change::slower)]) + " slower, " +
          std::to_string(counts[static_cast<std::size_t>(Change::faster)]) + " faster";
  for (const Change change : {Change::suspected_slower, Change::suspected_faster}) {
    const std::size_t count = counts.at(static_cast<std::size_t>(change));
    if (count > 0) text += ", " + std::to_string(count) + " " + to_string(change);
  }
  for (const MethodChange& method : comparison.methods) {
    if (method.change != Change::none)
      text += "; " + method.method + " " + to_string(method.change) + " over all cells";
  }
  if (lost > 0) text += "; " + counted(lost, "instance") + " no longer solved";
  if (comparison.contradictions > 0)
    text += "; " + counted(comparison.contradictions, "instance") + " with contradictory bounds";
  return text;
}

}  // namespace raygauge
