// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/panel_grid.h"

#include <algorithm>
#include <cmath>

#include "analysis/render/figures/style.h"
#include "results/text/language.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

using figure_style::screen;

/// As many as fit beside each other, but no more than four.
std::size_t legend_columns_of(const MethodList& methods, const std::string& flaw, double width) {
  constexpr double kCharacter = 0.065;  // inches
  constexpr double kSample = 0.75;      // line, marker and gaps
  constexpr double kMost = 4;
  std::size_t longest = flaw.size();
  for (const std::string& method : methods) longest = std::max(longest, method.size());
  const double column = kSample + kCharacter * static_cast<double>(longest);
  return static_cast<std::size_t>(std::clamp(std::floor(width / column), 1.0, kMost));
}

}  // namespace

double PanelGrid::panel_width() const {
  const auto count = static_cast<double>(columns);
  return (width - kLeft - kRight - (count - 1) * gap) / count;
}

double PanelGrid::panel_height() const {
  constexpr double kLargest = 3;
  return std::min(kLargest, columns == 1 ? 0.66 * panel_width() : 0.8 * panel_width());
}

double PanelGrid::height() const {
  return legend + kBottom + static_cast<double>(rows) * (panel_height() + kTitle + x_labels) - x_labels;
}

std::size_t PanelGrid::rows_a_page() const {
  constexpr double kPage = 9;
  const double room = kPage - legend - kBottom + x_labels;
  return static_cast<std::size_t>(std::max(1.0, std::floor(room / (panel_height() + kTitle + x_labels))));
}

std::string PanelGrid::margins(std::size_t panel) const {
  const auto column = static_cast<double>(panel % columns);
  const std::size_t above = panel / columns;
  const auto row = static_cast<double>(above);
  const double left = kLeft + column * (panel_width() + gap);
  const double top = height() - legend - kTitle - row * (panel_height() + kTitle + x_labels);
  return "set lmargin at screen " + screen(left / width) + "\nset rmargin at screen " +
         screen((left + panel_width()) / width) + "\nset tmargin at screen " + screen(top / height()) +
         "\nset bmargin at screen " + screen((top - panel_height()) / height()) + "\n";
}

std::string PanelGrid::axis_labels(const std::string& x, const std::string& y) const {
  return "set label 1 '" + x + "' at screen " + screen((kLeft + (width - kLeft - kRight) / 2) / width) +
         ", screen " + screen(0.09 / height()) + " center\nset label 2 '" + y + "' at screen " +
         screen(0.1 / width) + ", screen " +
         screen((kBottom + (height() - kBottom - legend) / 2) / height()) + " center rotate by 90\n";
}

std::string PanelGrid::legend_plot(const MethodList& methods) const {
  std::string text =
      "unset border\nunset tics\nset lmargin at screen 0.01\nset rmargin at screen 0.99\n"
      "set tmargin at screen 1\nset bmargin at screen " +
      screen(1 - legend / height()) + "\nset key at screen 0.5, screen " +
      screen(1 - 0.5 * legend / height()) +
      " center center horizontal Left reverse samplen 2.5 spacing 1 width 3 maxcols " +
      std::to_string(legend_columns) + "\n";
  for (const std::string& method : methods) {
    text += method == methods.front() ? "plot " : ", \\\n  ";
    text += "NaN with linespoints " + figure_style::line_style(method, methods) + " title " +
            language::gnuplot(method);
  }
  if (!flaw.empty())
    text += std::string(", \\\n  NaN with points ") + figure_style::kFlawStyle + " title " +
            language::gnuplot(flaw);
  return text +
         "\nunset key\nunset label\nset border 3 lw 0.6\nset xtics nomirror scale 0.5\nset ytics nomirror "
         "scale 0.5\n"
         "set grid ytics lc rgb '#CCCCCC' lw 0.5 dt 1\n";
}

PanelGrid panel_grid(std::size_t panels, const MethodList& methods, FigureSize size, std::size_t most_columns,
                     const std::string& flaw) {
  PanelGrid grid;
  grid.flaw = flaw;
  grid.width = width_of(size);
  grid.legend_columns = legend_columns_of(methods, flaw, grid.width);
  grid.columns = std::min(panels, most_columns);
  grid.rows = (panels + grid.columns - 1) / grid.columns;
  constexpr double kLegendLine = 0.17;
  const std::size_t legend_lines =
      (methods.size() + (flaw.empty() ? 0 : 1) + grid.legend_columns - 1) / grid.legend_columns;
  grid.legend = 0.05 + kLegendLine * static_cast<double>(legend_lines);
  return grid;
}

}  // namespace raygauge
