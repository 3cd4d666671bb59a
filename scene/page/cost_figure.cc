// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/cost_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engine/numerics/number_text.h"
#include "results/text/language.h"

namespace raygauge {
namespace {

struct Panel {
  const char* title;
  double (*value)(const SimulationRow& row);
};

constexpr std::array<Panel, 4> kPanels = {
    {{"distance from the finest / m", [](const SimulationRow& row) { return row.error; }},
     {"proven overlap, at most / m", [](const SimulationRow& row) { return -row.least_distance; }},
     {"rise of energy / J", [](const SimulationRow& row) { return row.energy_rise; }},
     {"residual of contacts, relative", [](const SimulationRow& row) { return row.residual; }}}};
constexpr std::array kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000"};
constexpr double kPanelHeight = 2.1;  // inches

using Curves = std::map<std::string, std::vector<const SimulationRow*>>;

/// By their titles: simulations of a tolerance, or of a step where there is no other; those of each other
/// engine.
Curves curves_of(const SimulationTables& tables) {
  const bool by_tolerance = tables.simulations.front().step != tables.simulations.back().step;
  Curves curves;
  for (const SimulationRow& row : tables.simulations) {
    const std::string own =
        by_tolerance ? "tolerance " + rounded_text(row.tolerance, 3) : "step " + rounded_text(row.step, 3);
    curves[row.engine == "raygauge" ? own : row.engine].push_back(&row);
  }
  return curves;
}

/// Where a value of 0 is drawn on a logarithmic axis: a decade below all others.
double place_of_zero(const Panel& panel, const SimulationTables& tables) {
  double least = std::numeric_limits<double>::infinity();
  for (const SimulationRow& row : tables.simulations) {
    const double value = panel.value(row);
    if (value > 0) least = std::min(least, value);
  }
  return std::isfinite(least) ? std::pow(10, std::floor(std::log10(least)) - 1) : 1e-16;
}

/// A panel; values that are not known are left out, where there are zeros the axis has a tick for them.
std::string panel_script(const Panel& panel, const SimulationTables& tables) {
  const double zero_at = place_of_zero(panel, tables);
  std::string blocks, plots;
  bool zeros = false;
  std::size_t number = 0;
  for (const auto& [title, rows] : curves_of(tables)) {
    std::string points;
    for (const SimulationRow* row : rows) {
      const double value = panel.value(*row);
      if (!std::isfinite(value)) continue;
      zeros = zeros || value <= 0;
      points += rounded_text(row->seconds, 7) + " " + rounded_text(value > 0 ? value : zero_at, 7) + "\n";
    }
    const std::string block = "$curve" + std::to_string(number);
    const std::string look = std::string(" with linespoints pt 7 ps 0.4 lw 1.3 lc rgb '") +
                             kColors[number++ % kColors.size()] + "' title " + language::gnuplot(title);
    if (points.empty()) continue;
    blocks += block + " << EOD\n" + points + "EOD\n";
    plots += (plots.empty() ? "plot " : ", \\\n  ") + block + " using 1:2" + look;
  }
  std::string script = "set title " + language::gnuplot(panel.title) + " offset 0,-0.7\nset ytics autofreq\n";
  if (plots.empty()) return script + "set multiplot next\n";  // none is known
  script += "set yrange [" + (zeros ? rounded_text(zero_at / 3, 7) : std::string("*")) + ":*]\n";
  if (zeros) script += "set ytics add ('0' " + rounded_text(zero_at, 7) + ")\n";
  return script + blocks + plots + "\n";
}

}  // namespace

Drawing draw_costs(const SimulationTables& tables, FigureSize size) {
  if (tables.simulations.size() < 2)
    throw FigureNeedsError("the figure 'cost' needs simulations of several steps, tolerances or engines");
  Drawing drawing;
  drawing.width = width_of(size);
  drawing.height = 2 * kPanelHeight;
  drawing.script =
      "set encoding utf8\nset border 3\nset tics nomirror out scale 0.5\nset logscale xy\nset format "
      "'10^{%T}'\n"
      "set key below center horizontal samplen 1\nset multiplot layout 2,2\nset xlabel 'time / s' offset "
      "0,0.5\n";
  for (const Panel& panel : kPanels) drawing.script += panel_script(panel, tables);
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
