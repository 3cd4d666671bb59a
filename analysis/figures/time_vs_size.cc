// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/time_vs_size.h"

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

/// What distinguishes the two figures.
struct SizeFigure {
  const char* name;
  bool against_N;  ///< against N, a panel for each n; else the other way round
  const char* size;
  const char* panel;
  const char* label;
};

constexpr SizeFigure kAgainstN = {"time_vs_N", true, "N", "n", "N, points in each set"};
constexpr SizeFigure kAgainstDimension = {"time_vs_n", false, "n", "N", "n, dimension"};

struct Point {
  int size = 0;
  double milliseconds = 0;
  Interval interval;
};

struct Panel {
  int other = 0;
  std::map<std::string, std::vector<Point>> curves;  ///< by method
};

/// What all panels share.
struct Axes {
  double size_low = std::numeric_limits<double>::infinity();
  double size_high = 0;
  double ms_low = std::numeric_limits<double>::infinity();
  double ms_high = 0;
  std::set<int> sizes;

  void include(const Point& point) {
    sizes.insert(point.size);
    size_low = std::min(size_low, static_cast<double>(point.size));
    size_high = std::max(size_high, static_cast<double>(point.size));
    ms_low = std::min(ms_low, point.interval.lower);
    ms_high = std::max(ms_high, point.interval.upper);
  }
};

std::vector<Panel> panels_of(const std::vector<Record>& records, const SizeFigure& figure) {
  std::map<int, Panel> panels;
  for (const CellTimes& times : cell_times(records)) {
    if (times.seconds.empty() || std::isinf(median(times.seconds))) continue;
    std::vector<double> milliseconds;
    for (const double seconds : times.seconds) milliseconds.push_back(1e3 * seconds);
    const int other = figure.against_N ? times.cell.n : times.cell.N;
    Point point{figure.against_N ? times.cell.N : times.cell.n, median(milliseconds),
                median_interval(milliseconds)};
    // A bar that has no end is drawn to the point.
    if (std::isinf(point.interval.upper)) point.interval.upper = point.milliseconds;
    Panel& panel = panels[other];
    panel.other = other;
    panel.curves[times.method].push_back(point);
  }
  std::vector<Panel> result;
  for (auto& [other, panel] : panels) result.push_back(std::move(panel));
  return result;
}

Axes axes_of(const std::vector<Panel>& panels, const SizeFigure& figure) {
  Axes axes;
  for (const Panel& panel : panels)
    for (const auto& [method, points] : panel.curves)
      for (const Point& point : points) axes.include(point);
  if (!(axes.size_low < axes.size_high))
    throw FigureNeedsError(std::string("figure ") + figure.name +
                           " needs solved records at two or more values of " + figure.size);
  constexpr double kMarginSize = 1.2;
  constexpr double kMarginTime = 1.4;
  axes.size_low /= kMarginSize;
  axes.size_high *= kMarginSize;
  axes.ms_low /= kMarginTime;
  axes.ms_high *= kMarginTime;
  return axes;
}

std::string data_block(const std::string& name, const std::vector<Point>& points) {
  std::string text = name + " << EOD\n";
  for (const Point& point : points) {
    text += std::to_string(point.size) + " " + significant(point.milliseconds, 6) + " " +
            significant(point.interval.lower, 6) + " " + significant(point.interval.upper, 6) + "\n";
  }
  return text + "EOD\n";
}

std::string block_name(std::size_t panel, std::size_t method) {
  return "$panel" + std::to_string(panel) + "curve" + std::to_string(method);
}

std::string common_settings(const Axes& axes, const PanelGrid& grid, const SizeFigure& figure) {
  return "set multiplot\nset logscale xy\nset xrange [" + significant(axes.size_low, 6) + ":" +
         significant(axes.size_high, 6) + "]\nset yrange [" + significant(axes.ms_low, 6) + ":" +
         significant(axes.ms_high, 6) + "]\n" + grid.axis_labels(figure.label, "median time of a solve (ms)");
}

/// Few sizes are marked themselves.
std::string size_ticks(const Axes& axes) {
  constexpr std::size_t kFew = 4;
  if (axes.sizes.size() > kFew) return figure_style::one_two_five_ticks(axes.size_low, axes.size_high);
  std::string ticks;
  for (const int size : axes.sizes) ticks += (ticks.empty() ? "" : ", ") + std::to_string(size);
  return "(" + ticks + ")";
}

std::string panel_settings(const PanelGrid& grid, std::size_t index, std::size_t count, const Axes& axes) {
  std::string text = grid.margins(index);
  text += std::string("set format x ") + (grid.is_lowest(index, count) ? "'%g'" : "''") + "\n";
  text += std::string("set format y ") + (grid.is_left(index) ? "'10^{%T}'" : "''") + "\n";
  return text + "set xtics nomirror " + size_ticks(axes) + "\n";
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

Drawing time_figure(const SizeFigure& figure, const std::vector<Record>& records,
                    const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(figure.name, records, options.filter);
  const std::vector<Panel> panels = panels_of(kept, figure);
  const std::vector<std::string> methods = methods_of(kept);
  const Axes axes = axes_of(panels, figure);
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
  drawing.script += common_settings(axes, grid, figure) + grid.legend_plot(methods);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    drawing.script += panel_settings(grid, p, panels.size(), axes) + "set title '" + figure.panel + " = " +
                      std::to_string(panels[p].other) + "' offset 0,-0.7\n" +
                      plot_command(panels[p], p, methods);
  }
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace

Drawing time_vs_N(const std::vector<Record>& records, const FigureOptions& options) {
  return time_figure(kAgainstN, records, options);
}

Drawing time_vs_n(const std::vector<Record>& records, const FigureOptions& options) {
  return time_figure(kAgainstDimension, records, options);
}

}  // namespace raygauge
