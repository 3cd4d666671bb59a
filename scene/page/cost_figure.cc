// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/cost_figure.h"

#include <array>
#include <cmath>
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
    {{"distance from the finest", [](const SimulationRow& row) { return row.error; }},
     {"proven overlap, at most", [](const SimulationRow& row) { return -row.least_distance; }},
     {"rise of energy", [](const SimulationRow& row) { return row.energy_rise; }},
     {"residual of contacts", [](const SimulationRow& row) { return row.residual; }}}};
constexpr std::array kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000"};
constexpr double kPanelHeight = 2.1;  // inches

using Curves = std::map<double, std::vector<const SimulationRow*>>;

/// Simulations of a tolerance, or of a step where there is no other.
Curves curves_of(const SimulationTables& tables, bool by_tolerance) {
  Curves curves;
  for (const SimulationRow& row : tables.simulations)
    curves[by_tolerance ? row.tolerance : row.step].push_back(&row);
  return curves;
}

bool has_several_steps(const SimulationTables& tables) {
  return tables.simulations.front().step != tables.simulations.back().step;
}

}  // namespace

Drawing draw_costs(const SimulationTables& tables, FigureSize size) {
  if (tables.simulations.size() < 2)
    throw FigureNeedsError("the figure 'cost' needs simulations of several steps or tolerances");
  const bool by_tolerance = has_several_steps(tables);
  const Curves curves = curves_of(tables, by_tolerance);
  Drawing drawing;
  drawing.width = width_of(size);
  drawing.height = 2 * kPanelHeight;
  drawing.script =
      "set encoding utf8\nset border 3\nset tics nomirror out scale 0.5\nset logscale xy\nset format "
      "'10^{%T}'\n"
      "set key bottom left samplen 1\nset multiplot layout 2,2\nset xlabel 'time / s' offset 0,0.5\n";
  for (const Panel& panel : kPanels) {
    std::string blocks, plots;
    std::size_t number = 0;
    for (const auto& [key, rows] : curves) {
      std::string points;
      for (const SimulationRow* row : rows) {
        const double value = panel.value(*row);
        if (value > 0 && std::isfinite(value))
          points += rounded_text(row->seconds, 7) + " " + rounded_text(value, 7) + "\n";
      }
      if (points.empty()) continue;
      const std::string block = "$curve" + std::to_string(number);
      blocks += block + " << EOD\n" + points + "EOD\n";
      plots += (plots.empty() ? "plot " : ", \\\n  ") + block +
               " using 1:2 with linespoints pt 7 ps 0.4 lw 1.3 lc rgb '" + kColors[number % kColors.size()] +
               "' title " + language::gnuplot((by_tolerance ? "tolerance " : "step ") + rounded_text(key, 3));
      ++number;
    }
    drawing.script += "set title " + language::gnuplot(panel.title) + " offset 0,-0.7\n";
    if (plots.empty()) {  // all of them 0
      drawing.script += "set multiplot next\n";
      continue;
    }
    drawing.script += blocks + plots + "\n";
  }
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
