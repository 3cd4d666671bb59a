// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/work_precision.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/pool.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/render/time_unit.h"
#include "analysis/studies/accuracy/accuracy_tables.h"

namespace raygauge {
namespace {

constexpr const char* kPrecisionNeeds =
    "figure work_precision needs solves of known truth (a generator that knows it, or records of the method "
    "exact) at "
    "two or more tolerances";

std::vector<PanelCurve> precision_curves(const AccuracyGroup& group, double AccuracyPoint::*quantity,
                                         const TimeUnit& unit) {
  std::vector<PanelCurve> curves;
  for (const AccuracyCurve& curve : group.curves) {
    PanelCurve drawn{curve.method, {}, {}, {}};
    for (const AccuracyPoint& point : curve.points) {
      if (std::isnan(point.*quantity)) continue;
      drawn.points.emplace_back(unit.per_second * point.median_seconds, drawn_error(point.*quantity));
      if (point.failures + point.wrong > 0) drawn.flaws.push_back(drawn.points.back());
    }
    curves.push_back(std::move(drawn));
  }
  return curves;
}

std::string time_axis(const std::pair<double, double>& range) {
  const auto [low, high] = range;
  constexpr double kManyTicks = 300;
  const std::string ticks = high / low > kManyTicks ? "10" : figure_style::one_two_five_ticks(low, high);
  return range_setting("x", low, high) + "set format x '%g'\nset xtics nomirror " + ticks + "\n";
}

/// The two panels of a group, on the same axes.
void add_panels(const AccuracyGroup& group, const TimeUnit& unit, std::vector<CurvePanel>& panels) {
  CurvePanel error{group.name + ": error", "", "",
                   precision_curves(group, &AccuracyPoint::mean_relative_error, unit)};
  CurvePanel gap{group.name + ": gap", "", "",
                 precision_curves(group, &AccuracyPoint::mean_relative_gap, unit)};
  std::vector<PanelCurve> both = error.curves;
  both.insert(both.end(), gap.curves.begin(), gap.curves.end());
  const std::string axes = "set logscale x\n" + time_axis(range_of(both, false, 1.2));
  error.settings = gap.settings = axes;
  panels.push_back(std::move(error));
  panels.push_back(std::move(gap));
}

bool has_precision(const AccuracyGroup& group) {
  return std::any_of(group.curves.begin(), group.curves.end(), [](const AccuracyCurve& curve) {
    return curve.points.size() >= 2 && std::isfinite(curve.points.front().mean_relative_error);
  });
}

/// That of all panels, which share the words below them.
TimeUnit unit_of(const std::vector<AccuracyGroup>& groups) {
  double least = kInfinity;
  double most = 0;
  for (const AccuracyGroup& group : groups) {
    if (!has_precision(group)) continue;
    for (const AccuracyCurve& curve : group.curves) {
      for (const AccuracyPoint& point : curve.points) {
        least = std::min(least, point.median_seconds);
        most = std::max(most, point.median_seconds);
      }
    }
  }
  return time_unit_for(least, most);
}

}  // namespace

Drawing work_precision(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept =
      figure_style::comparable_records("work_precision", records, options.filter);
  const std::vector<AccuracyGroup> groups = accuracy_groups(kept, Pool(records).truth_of(records));
  const TimeUnit unit = unit_of(groups);
  std::vector<CurvePanel> panels;
  MethodList methods;
  for (const AccuracyGroup& group : groups) {
    if (!has_precision(group)) continue;
    add_panels(group, unit, panels);
    for (const AccuracyCurve& curve : group.curves) {
      methods.add(curve.facts);
    }
  }
  if (panels.empty()) throw FigureNeedsError(kPrecisionNeeds);
  constexpr std::size_t kMostGroups = 32;
  if (panels.size() > 2 * kMostGroups)
    throw FigureNeedsError(
        "figure work_precision draws two panels for each generator, its parameters, n and N, and "
        "there are " +
        std::to_string(panels.size() / 2) + " of them; choose with --where");
  PanelGrid grid =
      panel_grid(panels.size(), methods, options.size, options.size == FigureSize::single ? 1 : 2,
                 has_flaws(panels) ? "some solves failed or wrong" : "");
  grid.x_labels = 0.2;
  for (std::size_t p = 0; p < panels.size(); ++p) panels[p].settings += error_axis(grid.is_left(p));
  return draw_curve_panels(grid, panels, methods, std::string("median time of a solve, ") + unit.name,
                           "relative error, relative gap");
}

}  // namespace raygauge
