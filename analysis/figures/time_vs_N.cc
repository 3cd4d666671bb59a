// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/time_vs_N.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "analysis/cell_ratio.h"
#include "analysis/figures/panel_grid.h"
#include "analysis/figures/style.h"
#include "analysis/number_text.h"
#include "analysis/statistics.h"

namespace raygauge {
namespace {

constexpr const char* kName = "time_vs_N";

struct Point {
  int N = 0;
  double milliseconds = 0;
  Interval interval;
};

struct Panel {
  int n = 0;
  std::map<std::string, std::vector<Point>> curves;  ///< by method
};

/// What all panels share.
struct Axes {
  double N_low = std::numeric_limits<double>::infinity();
  double N_high = 0;
  double ms_low = std::numeric_limits<double>::infinity();
  double ms_high = 0;
  std::set<int> N_values;

  void include(const Point& point) {
    N_values.insert(point.N);
    N_low = std::min(N_low, static_cast<double>(point.N));
    N_high = std::max(N_high, static_cast<double>(point.N));
    ms_low = std::min(ms_low, point.interval.lower);
    ms_high = std::max(ms_high, point.interval.upper);
  }
};

std::vector<Panel> panels_of(const std::vector<Record>& records) {
  std::map<int, Panel> panels;
  for (const CellTimes& times : cell_times(records)) {
    if (times.seconds.empty() || std::isinf(median(times.seconds))) continue;
    std::vector<double> milliseconds;
    for (const double seconds : times.seconds) milliseconds.push_back(1e3 * seconds);
    Point point{times.cell.N, median(milliseconds), median_interval(milliseconds)};
    // A bar that has no end is drawn to the point.
    if (std::isinf(point.interval.upper)) point.interval.upper = point.milliseconds;
    Panel& panel = panels[times.cell.n];
    panel.n = times.cell.n;
    panel.curves[times.method].push_back(point);
  }
  std::vector<Panel> result;
  for (auto& [n, panel] : panels) result.push_back(std::move(panel));
  return result;
}

Axes axes_of(const std::vector<Panel>& panels) {
  Axes axes;
  for (const Panel& panel : panels)
    for (const auto& [method, points] : panel.curves)
      for (const Point& point : points) axes.include(point);
  if (!(axes.N_low < axes.N_high))
    throw FigureNeedsError(std::string("figure ") + kName +
                           " needs solved records at two or more values of N");
  constexpr double kMarginN = 1.2;
  constexpr double kMarginTime = 1.4;
  axes.N_low /= kMarginN;
  axes.N_high *= kMarginN;
  axes.ms_low /= kMarginTime;
  axes.ms_high *= kMarginTime;
  return axes;
}

std::string data_block(const std::string& name, const std::vector<Point>& points) {
  std::string text = name + " << EOD\n";
  for (const Point& point : points) {
    text += std::to_string(point.N) + " " + significant(point.milliseconds, 6) + " " +
            significant(point.interval.lower, 6) + " " + significant(point.interval.upper, 6) + "\n";
  }
  return text + "EOD\n";
}

std::string block_name(std::size_t panel, std::size_t method) {
  return "$panel" + std::to_string(panel) + "curve" + std::to_string(method);
}

std::string common_settings(const Axes& axes, const PanelGrid& grid) {
  return "set multiplot\nset logscale xy\nset xrange [" + significant(axes.N_low, 6) + ":" +
         significant(axes.N_high, 6) + "]\nset yrange [" + significant(axes.ms_low, 6) + ":" +
         significant(axes.ms_high, 6) + "]\n" +
         grid.axis_labels("N, points in each set", "median time of a solve (ms)");
}

/// Few values of N are marked themselves.
std::string N_ticks(const Axes& axes) {
  constexpr std::size_t kFew = 4;
  if (axes.N_values.size() > kFew) return figure_style::one_two_five_ticks(axes.N_low, axes.N_high);
  std::string ticks;
  for (const int N : axes.N_values) ticks += (ticks.empty() ? "" : ", ") + std::to_string(N);
  return "(" + ticks + ")";
}

std::string panel_settings(const PanelGrid& grid, std::size_t index, std::size_t count, const Axes& axes) {
  std::string text = grid.margins(index);
  text += std::string("set format x ") + (grid.is_lowest(index, count) ? "'%g'" : "''") + "\n";
  text += std::string("set format y ") + (grid.is_left(index) ? "'10^{%T}'" : "''") + "\n";
  return text + "set xtics nomirror " + N_ticks(axes) + "\n";
}

std::string plot_command(const Panel& panel, std::size_t index, const std::vector<std::string>& methods) {
  std::string text;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (panel.curves.count(methods[m]) == 0) continue;
    const std::string block = block_name(index, m);
    text += text.empty() ? "plot " : ", \\\n  ";
    text.append(block).append(" using 1:3:(0):($4-$3) with vectors nohead lw 0.7 lc rgb '");
    text += figure_style::line_color(methods[m], methods) + "', \\\n  " + block +
            " using 1:2 with linespoints " + figure_style::line_style(methods[m], methods);
  }
  return text + "\n";
}

}  // namespace

Drawing time_vs_N(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(kName, records, options.filter);
  const std::vector<Panel> panels = panels_of(kept);
  const std::vector<std::string> methods = methods_of(kept);
  const Axes axes = axes_of(panels);
  const PanelGrid grid =
      panel_grid(panels.size(), methods.size(), options.size, options.size == FigureSize::single ? 2 : 4);

  Drawing drawing;
  drawing.width = grid.width;
  drawing.height = grid.height();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto curve = panels[p].curves.find(methods[m]);
      if (curve != panels[p].curves.end()) drawing.script += data_block(block_name(p, m), curve->second);
    }
  }
  drawing.script += common_settings(axes, grid) + grid.legend_plot(methods);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    drawing.script += panel_settings(grid, p, panels.size(), axes) +
                      "set title 'n = " + std::to_string(panels[p].n) + "' offset 0,-0.7\n" +
                      plot_command(panels[p], p, methods);
  }
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
