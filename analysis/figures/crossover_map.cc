// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/crossover_map.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "analysis/crossover.h"
#include "analysis/figures/style.h"
#include "analysis/number_text.h"

namespace raygauge {
namespace {

constexpr const char* kCrossoverName = "crossover";

/// Inches.
struct CrossoverLayout {
  double width = 0;
  std::size_t rows = 0;
  std::size_t columns = 0;
  static constexpr double kLeft = 0.45;
  static constexpr double kRight = 0.1;
  static constexpr double kTop = 0.32;
  static constexpr double kBottom = 0.4;
  static constexpr double kRow = 0.2;

  double height() const { return kTop + kRow * static_cast<double>(rows) + kBottom; }
  double font_size() const {
    constexpr double kPointsPerInch = 72;
    constexpr double kEms = 6 * 0.62;
    constexpr double kLargest = 7;
    return std::min(kLargest,
                    kPointsPerInch * (width - kLeft - kRight) / static_cast<double>(columns) / kEms);
  }
};

std::string ticks_of(const std::set<int>& values) {
  std::string text;
  int place = 0;
  for (const int value : values)
    text += (text.empty() ? "('" : ", '") + std::to_string(value) + "' " + std::to_string(place++);
  return text + ")";
}

char letter_of(const std::string& method, const std::vector<std::string>& methods) {
  return static_cast<char>('a' + (std::find(methods.begin(), methods.end(), method) - methods.begin()) % 26);
}

/// Column, row, text and colour of the text of the cells that a method wins.
std::string winner_block(std::size_t index, const std::string& method, const std::vector<CellWinner>& winners,
                         const std::set<int>& n, const std::set<int>& N, char letter) {
  std::string text = "$winner" + std::to_string(index) + " << EOD\n";
  for (const CellWinner& winner : winners) {
    if (winner.method != method) continue;
    std::string label(1, letter);
    if (!winner.runner_up.empty())
      label += " " + padded_significant(winner.lead.ratio, 2) + (winner.decided ? "" : "?");
    text += std::to_string(std::distance(N.begin(), N.find(winner.cell.N))) + " " +
            std::to_string(std::distance(n.begin(), n.find(winner.cell.n))) + " \"" + label + "\"\n";
  }
  return text + "EOD\n";
}

std::string crossover_settings(const CrossoverLayout& layout, const std::set<int>& n,
                               const std::set<int>& N) {
  const double height = layout.height();
  const auto screen = [](double value) { return significant(value, 6); };
  return "unset key\nset border 0\nset style fill transparent solid 0.45 noborder\nset xtics " + ticks_of(N) +
         " scale 0 font '," + significant(layout.font_size(), 3) + "'\nset ytics " + ticks_of(n) +
         " scale 0\nset xlabel 'N, points in each set' offset 0,0.6\nset ylabel 'n' offset 1.5,0 rotate by "
         "0\n"
         "set xrange [-0.5:" +
         std::to_string(N.size()) + "-0.5]\nset yrange [" + std::to_string(n.size()) + "-0.5:-0.5]\n" +
         "set lmargin at screen " + screen(CrossoverLayout::kLeft / layout.width) +
         "\nset rmargin at screen " + screen(1 - CrossoverLayout::kRight / layout.width) +
         "\nset tmargin at screen " + screen(1 - CrossoverLayout::kTop / height) +
         "\nset bmargin at screen " + screen(CrossoverLayout::kBottom / height) + "\n";
}

}  // namespace

Drawing crossover_figure(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(kCrossoverName, records, options.filter);
  const std::vector<std::string> methods = methods_of(kept);
  const std::vector<CellWinner> winners = cell_winners(kept);
  if (methods.size() < 2 || winners.empty()) {
    throw FigureNeedsError(std::string("figure ") + kCrossoverName +
                           " needs solved records of two or more methods");
  }
  std::set<int> n;
  std::set<int> N;
  for (const CellWinner& winner : winners) {
    n.insert(winner.cell.n);
    N.insert(winner.cell.N);
  }
  const CrossoverLayout layout{width_of(options.size), n.size(), N.size()};
  Drawing drawing;
  drawing.width = layout.width;
  drawing.height = layout.height();
  std::string boxes;
  std::string labels;
  std::string heading;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const bool wins = std::any_of(winners.begin(), winners.end(),
                                  [&](const CellWinner& winner) { return winner.method == methods[m]; });
    if (!wins) continue;
    const char letter = letter_of(methods[m], methods);
    drawing.script += winner_block(m, methods[m], winners, n, N, letter);
    const std::string block = "$winner" + std::to_string(m);
    boxes += (boxes.empty() ? "plot " : ", \\\n  ") + block +
             " using 1:2:($1-0.48):($1+0.48):($2-0.46):($2+0.46) with boxxyerror lc rgb '" +
             figure_style::line_color(methods[m], methods) + "'";
    labels +=
        ", \\\n  " + block + " using 1:2:3 with labels font '," + significant(layout.font_size(), 3) + "'";
    heading += (heading.empty() ? "fastest: " : ", ") + std::string(1, letter) + " " + methods[m];
  }
  drawing.script += crossover_settings(layout, n, N) + "set label 9 " +
                    figure_style::quoted(heading + "; second takes so many times longer") +
                    " at screen 0.5, screen " + significant(1 - 0.12 / layout.height(), 6) + " center\n" +
                    boxes + labels + "\n";
  return drawing;
}

}  // namespace raygauge
