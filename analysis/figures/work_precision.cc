// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/work_precision.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/accuracy_tables.h"
#include "analysis/figures/curve_panel.h"
#include "analysis/figures/style.h"

namespace raygauge {
namespace {

constexpr const char* kNeeds =
    "figure work_precision needs solves of known truth (a generator that knows it, or records of the method "
    "exact) at "
    "two or more tolerances";
constexpr double kLowestDrawn = 1e-17;
constexpr const char* kLargestDrawn = "10";

std::vector<PanelCurve> precision_curves(const AccuracyGroup& group, double AccuracyPoint::*quantity) {
  constexpr double kMicroseconds = 1e6;
  std::vector<PanelCurve> curves;
  for (const AccuracyCurve& curve : group.curves) {
    PanelCurve drawn{curve.method, {}};
    for (const AccuracyPoint& point : curve.points) {
      if (!std::isfinite(point.*quantity)) continue;
      drawn.points.emplace_back(kMicroseconds * point.median_seconds,
                                std::max(point.*quantity, kLowestDrawn));
    }
    curves.push_back(std::move(drawn));
  }
  return curves;
}

std::string precision_ticks(bool labelled) {
  std::string ticks = labelled ? "'0' 1e-17" : "'' 1e-17";
  for (const int exponent : {-15, -12, -9, -6, -3, 0}) {
    const std::string power = std::to_string(exponent);
    ticks += ", '" + (labelled ? "10^{" + power + "}" : std::string()) + "' 1e" + power;
  }
  return "set ytics nomirror (" + ticks + ")\n";
}

std::string time_axis(const std::pair<double, double>& range) {
  const auto [low, high] = range;
  constexpr double kManyTicks = 300;
  const std::string ticks = high / low > kManyTicks ? "10" : figure_style::one_two_five_ticks(low, high);
  return range_setting("x", low, high) + "set format x '%g'\nset xtics nomirror " + ticks + "\n";
}

/// The two panels of a group, on the same axes.
void add_panels(const AccuracyGroup& group, std::vector<CurvePanel>& panels) {
  CurvePanel error{group.name + ": error", "", "",
                   precision_curves(group, &AccuracyPoint::mean_relative_error)};
  CurvePanel gap{group.name + ": gap", "", "", precision_curves(group, &AccuracyPoint::mean_relative_gap)};
  const std::string axes = "set logscale xy\nset yrange [3e-18:" + std::string(kLargestDrawn) + "]\n" +
                           time_axis(range_of(error.curves, false, 1.2));
  error.settings = axes + precision_ticks(true);
  gap.settings = axes + precision_ticks(false);
  panels.push_back(std::move(error));
  panels.push_back(std::move(gap));
}

bool has_precision(const AccuracyGroup& group) {
  return std::any_of(group.curves.begin(), group.curves.end(), [](const AccuracyCurve& curve) {
    return curve.points.size() >= 2 && std::isfinite(curve.points.front().mean_relative_error);
  });
}

}  // namespace

Drawing work_precision(const std::vector<Record>& records, const FigureOptions& options) {
  std::vector<AccuracyGroup> groups;
  try {
    groups = accuracy_groups(records, options.filter);
  } catch (const EmptySetError&) {
    throw FigureNeedsError(kNeeds);
  }
  std::vector<CurvePanel> panels;
  std::vector<std::string> methods;
  for (const AccuracyGroup& group : groups) {
    if (!has_precision(group)) continue;
    add_panels(group, panels);
    for (const AccuracyCurve& curve : group.curves) {
      if (std::find(methods.begin(), methods.end(), curve.method) == methods.end())
        methods.push_back(curve.method);
    }
  }
  if (panels.empty()) throw FigureNeedsError(kNeeds);
  PanelGrid grid = panel_grid(panels.size(), methods.size(), options.size, 2);
  grid.x_labels = 0.2;
  return draw_curve_panels(grid, panels, methods, "median time of a solve, µs",
                           "relative error, relative gap");
}

}  // namespace raygauge
