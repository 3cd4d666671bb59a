// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/crossover/crossover_map.h"

#include <algorithm>
#include <string>

#include "analysis/render/figures/cell_map.h"
#include "analysis/render/figures/problem_pages.h"
#include "analysis/render/figures/style.h"
#include "analysis/studies/crossover/crossover.h"
#include "results/text/language.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

using figure_style::screen;

constexpr const char* kCrossoverName = "crossover";

/// Inches.
constexpr double kCrossoverRight = 0.1;
constexpr double kCrossoverHeading = 0.2;
constexpr double kKeyLine = 0.16;
constexpr double kWinnerCharacters = 6;  // "a 1.2?"

/// The methods that win somewhere, in their order.
std::vector<std::string> winning_methods(const std::vector<std::string>& methods,
                                         const std::vector<CellWinner>& winners) {
  std::vector<std::string> winning;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(winning), [&](const std::string& method) {
    return std::any_of(winners.begin(), winners.end(),
                       [&](const CellWinner& winner) { return winner.method == method; });
  });
  return winning;
}

/// What stands before a method's numbers, so that its cells are told from others' in grey; nothing where one
/// method wins all.
std::string mark_of(std::size_t index, std::size_t winning) {
  constexpr std::size_t kLetters = 26;
  return winning < 2 ? "" : std::string(1, static_cast<char>('a' + index % kLetters)) + " ";
}

/// Column, row and text of the cells that a method wins.
std::string winner_block(const std::string& name, const std::string& method,
                         const std::vector<CellWinner>& winners, const CellMap& map,
                         const std::string& mark) {
  std::string text = name + " << EOD\n";
  for (const CellWinner& winner : winners) {
    if (winner.method != method) continue;
    const std::string lead = winner.runner_up.empty() ? "only" : padded_significant(winner.lead.ratio, 2);
    text.append(map.place(winner.cell)).append(" \"").append(mark).append(lead);
    text += winner.runner_up.empty() || winner.decided ? "\"\n" : "?\"\n";
  }
  return text + "EOD\n";
}

/// Heading and key above the cells.
std::string crossover_legend(const std::string& problem, double height, std::size_t key_columns) {
  const std::string where = problem.empty() ? "" : problem + ": ";
  return "set label 9 " + language::gnuplot(where + "fastest method; time of the second / its own") +
         " at screen 0.5, screen " + screen(1 - 0.1 / height) + " center\nset key at screen 0.5, screen " +
         screen(1 - kCrossoverHeading / height) +
         " center top horizontal Left reverse samplen 1.2 spacing 0.9 width 1 maxcols " +
         std::to_string(key_columns) + "\n";
}

Drawing crossover_of(const Problem& problem, const FigureOptions& options) {
  const std::vector<Record>& kept = problem.records;
  const MethodList methods = methods_of(kept);
  const std::vector<CellWinner> winners = cell_winners(kept);
  if (methods.size() < 2 || winners.empty()) {
    throw FigureNeedsError(std::string("figure ") + kCrossoverName +
                           " needs solved records of two or more methods");
  }
  std::vector<CellKey> cells;
  for (const CellWinner& winner : winners) cells.push_back(winner.cell);
  require_two_cells(kCrossoverName, cells);
  const CellMap map(cells, width_of(options.size), kCrossoverRight);
  const std::vector<std::string> winning = winning_methods(methods, winners);
  const std::size_t key_columns = options.size == FigureSize::single ? 2 : 4;
  const std::size_t key_lines = (winning.size() + key_columns - 1) / key_columns;
  const double top = CellMap::kBottom + map.height();

  Drawing drawing;
  drawing.width = map.width();
  drawing.height = top + kKeyLine * static_cast<double>(key_lines) + kCrossoverHeading + 0.06;
  std::string boxes;
  std::string labels;
  for (std::size_t w = 0; w < winning.size(); ++w) {
    const std::string mark = mark_of(w, winning.size());
    const std::string block = "$winner" + std::to_string(w);
    drawing.script += winner_block(block, winning[w], winners, map, mark);
    boxes += (boxes.empty() ? "plot " : ", \\\n  ") + block + " using " + kCellBox +
             " with boxxyerror lc rgb '" + figure_style::line_color(winning[w], methods) + "' title " +
             language::gnuplot(mark + winning[w]);
    labels += ", \\\n  " + block + " using 1:2:3 with labels " + map.font(kWinnerCharacters) + " notitle";
  }
  drawing.script += "set style fill transparent solid 0.45 noborder\n" + map.settings() +
                    map.margins(top, drawing.height) + map.bottom_axis(kWinnerCharacters) +
                    crossover_legend(problem.name, drawing.height, key_columns) + boxes + labels + "\n";
  return drawing;
}

}  // namespace

Drawing crossover_figure(const std::vector<Record>& records, const FigureOptions& options) {
  return page_for_each_problem(kCrossoverName, records, options.filter,
                               [&](const Problem& problem) { return crossover_of(problem, options); });
}

}  // namespace raygauge
