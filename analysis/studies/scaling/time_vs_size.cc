// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/scaling/time_vs_size.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/constants.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/render/time_unit.h"
#include "analysis/studies/scaling/scaling.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

/// What distinguishes the two figures.
struct SizeFigure {
  const char* name;
  SizeAxis axis;
  const char* size;
  const char* panel;
  const char* label;
};

constexpr SizeFigure kAgainstN = {"time_vs_N", SizeAxis::N, "N", "n", "N, points in each set"};
constexpr SizeFigure kAgainstDimension = {"time_vs_dimension", SizeAxis::n, "n", "N", "n, dimension"};

/// What of a panel's cell its title must name: generator and tolerance only where there are several.
struct PanelTitles {
  explicit PanelTitles(const std::vector<ScalingCurve>& curves) {
    for (const ScalingCurve& curve : curves) {
      problems.insert(problem_name(curve.cell));
      tolerances.insert(curve.cell.tolerance);
    }
  }
  std::string title(const ScalingCurve& curve, const std::string& size) const {
    std::string text = problems.size() > 1 ? problem_name(curve.cell) + ", " : "";
    if (tolerances.size() > 1) text += "ε = " + rounded_text(curve.cell.tolerance, 3) + ", ";
    return text + size;
  }
  std::set<std::string> problems;
  std::set<double> tolerances;
};

/// A panel for each value of the other size.
std::vector<CurvePanel> size_panels(const std::vector<ScalingCurve>& curves, const SizeFigure& figure,
                                    double per_second) {
  const PanelTitles titles(curves);
  std::map<std::tuple<std::string, double, int>, CurvePanel> panels;
  for (const ScalingCurve& curve : curves) {
    const int other = figure.axis == SizeAxis::N ? curve.cell.n : curve.cell.N;
    CurvePanel& panel = panels[{problem_name(curve.cell), curve.cell.tolerance, other}];
    PanelCurve drawn{curve.method, {}, {}, {}};
    for (std::size_t i = 0; i < curve.sizes.size(); ++i) {
      const double time = per_second * curve.medians[i];
      const double upper = per_second * curve.intervals[i].upper;
      drawn.points.emplace_back(curve.sizes[i], time);
      if (curve.unsolved[i] + curve.disagreeing[i] > 0) drawn.flaws.emplace_back(curve.sizes[i], time);
      // A bar that has no end is drawn to the point.
      drawn.bars.emplace_back(per_second * curve.intervals[i].lower, std::isinf(upper) ? time : upper);
    }
    panel.title = titles.title(curve, std::string(figure.panel) + " = " + std::to_string(other));
    panel.curves.push_back(std::move(drawn));
  }
  std::vector<CurvePanel> result;
  for (auto& [key, panel] : panels) {
    const bool has_curve = std::any_of(panel.curves.begin(), panel.curves.end(),
                                       [](const PanelCurve& curve) { return curve.points.size() > 1; });
    if (has_curve) result.push_back(std::move(panel));
  }
  return result;
}

/// More panels than anybody looks at are refused: `--where` chooses.
void require_few(const std::vector<CurvePanel>& panels, const SizeFigure& figure) {
  constexpr std::size_t kMostPanels = 64;
  if (panels.size() <= kMostPanels) return;
  throw FigureNeedsError(std::string("figure ") + figure.name +
                         " draws a panel for each generator, its parameters, tolerance and " + figure.panel +
                         ", and there are " + std::to_string(panels.size()) + "; choose with --where");
}

/// Every size is marked, and named where there is room; where that is for few, round numbers are instead.
std::string size_ticks(const std::set<double>& sizes, const std::pair<double, double>& range,
                       double panel_width, bool labelled) {
  constexpr double kDigit = 0.07;   // inches
  constexpr double kEnough = 0.75;  // of the sizes
  const double inches = panel_width / std::log(range.second / range.first);
  std::string ticks;
  std::size_t named = 0;
  double begin = panel_width + 2 * kDigit;  // of the label to the right; the last one may stick out
  for (const double size : std::vector<double>(sizes.rbegin(), sizes.rend())) {
    const std::string label = rounded_text(size, 12);
    const double half = kDigit * static_cast<double>(label.size()) / 2;
    const double place = inches * std::log(size / range.first);
    const bool fits = place + half < begin - kDigit / 2;
    if (fits) begin = place - half;
    named += fits ? 1 : 0;
    ticks += (ticks.empty() ? "'" : ", '") + (fits && labelled ? label : std::string()) + "' " + label;
  }
  if (static_cast<double>(named) < kEnough * static_cast<double>(sizes.size()))
    return figure_style::one_two_five_ticks(range.first, range.second);
  return "(" + ticks + ")";
}

/// All panels have the same axes; only the outer ones have numbers.
void set_axes(std::vector<CurvePanel>& panels, const PanelGrid& grid, const SizeFigure& figure) {
  std::vector<PanelCurve> all;
  std::set<double> sizes;
  for (const CurvePanel& panel : panels) {
    for (const PanelCurve& curve : panel.curves) {
      all.push_back(curve);
      for (const auto& [size, ms] : curve.points) sizes.insert(size);
    }
  }
  if (sizes.size() < 2) {
    throw FigureNeedsError(std::string("figure ") + figure.name +
                           " needs solved records at two or more values of " + figure.size);
  }
  const std::pair<double, double> range = range_of(all, false, 1.2);
  const auto [low, high] = range_of(all, true, 1.4);
  const std::string axes =
      "set logscale xy\n" + range_setting("x", range.first, range.second) + range_setting("y", low, high);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const bool lowest = grid.is_lowest(p, panels.size());
    panels[p].settings = axes + "set format x " + (lowest ? "'%g'" : "''") + "\nset xtics nomirror " +
                         size_ticks(sizes, range, grid.panel_width(), lowest) + "\nset format y " +
                         (grid.is_left(p) ? "'10^{%T}'" : "''") + "\n";
  }
}

Drawing time_figure(const SizeFigure& figure, const std::vector<Record>& records,
                    const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(figure.name, records, options.filter);
  const MethodList methods = methods_of(kept);
  const std::vector<ScalingCurve> curves = scaling_curves(kept, figure.axis, 1);
  const TimeUnit unit = unit_of(curves);
  std::vector<CurvePanel> panels = size_panels(curves, figure, unit.per_second);
  require_few(panels, figure);
  // Titles with the name of a generator need room.
  const bool long_titles = !panels.empty() && panels.front().title.size() > 16;
  const std::size_t most_columns = (options.size == FigureSize::single ? 2 : 4) / (long_titles ? 2 : 1);
  const PanelGrid grid = panel_grid(std::max<std::size_t>(1, panels.size()), methods, options.size,
                                    most_columns, has_flaws(panels) ? "some answers wrong or missing" : "");
  set_axes(panels, grid, figure);
  return draw_curve_panels(grid, panels, methods, figure.label,
                           center_words(curves) + " time of a solve (" + unit.name + ")");
}

}  // namespace

Drawing time_vs_N(const std::vector<Record>& records, const FigureOptions& options) {
  return time_figure(kAgainstN, records, options);
}

Drawing time_vs_dimension(const std::vector<Record>& records, const FigureOptions& options) {
  return time_figure(kAgainstDimension, records, options);
}

}  // namespace raygauge
