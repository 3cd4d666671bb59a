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

/// Where things are, in inches.
struct Layout {
  std::size_t columns = 1;
  std::size_t rows = 1;
  std::size_t legend_columns = 1;
  double width = 0;
  double legend = 0;
  static constexpr double kLeft = 0.52;
  static constexpr double kRight = 0.08;
  static constexpr double kBottom = 0.42;
  static constexpr double kTitle = 0.2;
  static constexpr double kGap = 0.12;

  double panel_width() const {
    const auto count = static_cast<double>(columns);
    return (width - kLeft - kRight - (count - 1) * kGap) / count;
  }
  double panel_height() const { return columns == 1 ? 0.66 * panel_width() : 0.8 * panel_width(); }
  double height() const { return legend + kBottom + static_cast<double>(rows) * (panel_height() + kTitle); }
};

Layout layout_of(std::size_t panels, std::size_t methods, FigureSize size) {
  const std::size_t most = size == FigureSize::single ? 2 : 4;
  Layout layout;
  layout.legend_columns = size == FigureSize::single ? 2 : 4;
  layout.width = width_of(size);
  layout.columns = std::min(panels, most);
  layout.rows = (panels + layout.columns - 1) / layout.columns;
  constexpr double kLegendLine = 0.17;
  const std::size_t legend_lines = (methods + layout.legend_columns - 1) / layout.legend_columns;
  layout.legend = 0.05 + kLegendLine * static_cast<double>(legend_lines);
  return layout;
}

std::string fraction(double value) { return significant(value, 6); }

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

std::string common_settings(const Axes& axes, const Layout& layout) {
  const double height = layout.height();
  return "set multiplot\n"
         "set logscale xy\n"
         "set xrange [" +
         significant(axes.N_low, 6) + ":" + significant(axes.N_high, 6) +
         "]\n"
         "set yrange [" +
         significant(axes.ms_low, 6) + ":" + significant(axes.ms_high, 6) +
         "]\n"
         "set label 1 'N, points in each set' at screen " +
         fraction((Layout::kLeft + (layout.width - Layout::kLeft - Layout::kRight) / 2) / layout.width) +
         ", screen " + fraction(0.09 / height) +
         " center\n"
         "set label 2 'median time of a solve (ms)' at screen " +
         fraction(0.1 / layout.width) + ", screen " +
         fraction((Layout::kBottom + (height - Layout::kBottom - layout.legend) / 2) / height) +
         " center rotate by 90\n";
}

/// The legend is a plot of its own across the whole width: inside a panel it would have to fit there.
std::string legend_plot(const Layout& layout, const std::vector<std::string>& methods) {
  const double height = layout.height();
  std::string text =
      "unset border\nunset tics\nset lmargin at screen 0.01\nset rmargin at screen 0.99\n"
      "set tmargin at screen 1\nset bmargin at screen " +
      fraction(1 - layout.legend / height) + "\nset key at screen 0.5, screen " +
      fraction(1 - 0.5 * layout.legend / height) +
      " center center horizontal Left reverse samplen 2.5 spacing 1 width 3 maxcols " +
      std::to_string(layout.legend_columns) + "\n";
  for (const std::string& method : methods) {
    text += method == methods.front() ? "plot " : ", \\\n  ";
    text += "NaN with linespoints " + figure_style::line_style(method, methods) + " title " +
            figure_style::quoted(method);
  }
  return text +
         "\nunset key\nunset label\nset border 3 lw 0.6\nset xtics nomirror scale 0.5\nset ytics nomirror "
         "scale 0.5\n"
         "set grid ytics lc rgb '#CCCCCC' lw 0.5 dt 1\n";
}

/// Few values of N are marked themselves.
std::string N_ticks(const Axes& axes) {
  constexpr std::size_t kFew = 4;
  if (axes.N_values.size() > kFew) return figure_style::one_two_five_ticks(axes.N_low, axes.N_high);
  std::string ticks;
  for (const int N : axes.N_values) ticks += (ticks.empty() ? "" : ", ") + std::to_string(N);
  return "(" + ticks + ")";
}

std::string panel_settings(const Layout& layout, std::size_t index, std::size_t count, const Axes& axes) {
  const std::size_t column = index % layout.columns;
  const std::size_t row = index / layout.columns;
  const double height = layout.height();
  const double left = Layout::kLeft + static_cast<double>(column) * (layout.panel_width() + Layout::kGap);
  const double top = height - layout.legend - Layout::kTitle -
                     static_cast<double>(row) * (layout.panel_height() + Layout::kTitle);
  const bool lowest = index + layout.columns >= count;
  std::string text = "set lmargin at screen " + fraction(left / layout.width) + "\nset rmargin at screen " +
                     fraction((left + layout.panel_width()) / layout.width) + "\nset tmargin at screen " +
                     fraction(top / height) + "\nset bmargin at screen " +
                     fraction((top - layout.panel_height()) / height) + "\n";
  text += std::string("set format x ") + (lowest ? "'%g'" : "''") + "\n";
  text += std::string("set format y ") + (column == 0 ? "'10^{%T}'" : "''") + "\n";
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
  const Layout layout = layout_of(panels.size(), methods.size(), options.size);

  Drawing drawing;
  drawing.width = layout.width;
  drawing.height = layout.height();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto curve = panels[p].curves.find(methods[m]);
      if (curve != panels[p].curves.end()) drawing.script += data_block(block_name(p, m), curve->second);
    }
  }
  drawing.script += common_settings(axes, layout) + legend_plot(layout, methods);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    drawing.script += panel_settings(layout, p, panels.size(), axes) +
                      "set title 'n = " + std::to_string(panels[p].n) + "' offset 0,-0.7\n" +
                      plot_command(panels[p], p, methods);
  }
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
