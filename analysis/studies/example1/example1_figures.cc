// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/example1/example1_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/render/time_unit.h"
#include "analysis/studies/example1/example1_table.h"
#include "analysis/studies/table3/paper.h"

namespace raygauge {
namespace {

/// The curves of one quantity. Points that are not positive (N_rs of a method that shoots no rays) are left
/// out.
std::vector<PanelCurve> curves_of(const Example1Table& table, double AccuracyPoint::*quantity, double unit) {
  std::vector<PanelCurve> curves;
  for (const AccuracyCurve& curve : table.curves) {
    PanelCurve drawn{curve.method, {}, {}, {}};
    for (const AccuracyPoint& point : curve.points) {
      const double value = unit * point.*quantity;
      if (!(value > 0)) continue;
      drawn.points.emplace_back(point.tolerance, value);
      if (point.failures + point.wrong > 0) drawn.flaws.emplace_back(point.tolerance, value);
    }
    curves.push_back(std::move(drawn));
  }
  return curves;
}

PanelCurve paper_curve(Example1Roles roles, double paper::AccuracyRow::*quantity) {
  PanelCurve curve{figure_style::kPaperCurve, {}, {}, {}};
  for (const paper::AccuracyRow& row :
       roles == Example1Roles::cone_ellipsoid ? paper::table1() : paper::table2())
    curve.points.emplace_back(row.tolerance, row.*quantity);
  return curve;
}

/// Tolerances decrease to the right.
std::string tolerance_axis(const std::vector<PanelCurve>& curves) {
  const auto [low, high] = range_of(curves, false, 1.6);
  return range_setting("x", high, low) + "set xtics nomirror " + figure_style::decade_ticks(low, high) + "\n";
}

CurvePanel error_panel(const Example1Table& table) {
  CurvePanel panel{"(a) mean error", "", "x with lines lc rgb '#CCCCCC' lw 0.8 dt 1",
                   curves_of(table, &AccuracyPoint::mean_error, 1)};
  panel.curves.push_back(paper_curve(table.roles, &paper::AccuracyRow::error));
  const auto [low, high] = range_of(panel.curves, true, 3);
  panel.settings = tolerance_axis(panel.curves) +
                   "set logscale xy\nset format y '10^{%L}'\nset ytics nomirror 100\n" +
                   range_setting("y", low, high);
  return panel;
}

CurvePanel time_panel(const Example1Table& table) {
  const auto [least, most] = range_of(curves_of(table, &AccuracyPoint::mean_seconds, 1), true, 1);
  const TimeUnit unit = time_unit_for(least, most);
  CurvePanel panel{std::string("(b) mean time, ") + unit.name, "", "",
                   curves_of(table, &AccuracyPoint::mean_seconds, unit.per_second)};
  const auto [low, high] = range_of(panel.curves, true, 1.3);
  panel.settings = tolerance_axis(panel.curves) + "set format y '%g'\nset ytics nomirror " +
                   figure_style::one_two_five_ticks(low, high) + "\n" + range_setting("y", low, high);
  return panel;
}

CurvePanel iteration_panel(const Example1Table& table) {
  CurvePanel panel{"(c) mean N_rs", "", "", curves_of(table, &AccuracyPoint::N_rs, 1)};
  panel.curves.push_back(paper_curve(table.roles, &paper::AccuracyRow::N_rs));
  const auto [low, high] = range_of(panel.curves, true, 1.05);
  panel.settings = tolerance_axis(panel.curves) +
                   "unset logscale y\nset format y '%g'\nset ytics nomirror autofreq\n" +
                   range_setting("y", std::min(0.0, low), high);
  return panel;
}

Example1Table table_for(const std::string& name, const std::vector<Record>& records, Example1Roles roles,
                        const FigureOptions& options) {
  const std::string needs =
      "figure " + name + " needs records of generator example1 in its roles at two tolerances";
  figure_style::comparable_records(name, records, options.filter);
  try {
    Example1Table table = make_example1_table(records, roles, options.filter);
    for (const AccuracyCurve& curve : table.curves) {
      if (curve.points.size() >= 2) return table;
    }
  } catch (const EmptySetError&) {
    throw FigureNeedsError(needs);
  }
  throw FigureNeedsError(needs);
}

Drawing example1_figure(const std::string& name, const std::vector<Record>& records, Example1Roles roles,
                        const FigureOptions& options) {
  const Example1Table table = table_for(name, records, roles, options);
  MethodList methods;
  for (const AccuracyCurve& curve : table.curves) methods.add(curve.facts);
  methods.add({figure_style::kPaperCurve, figure_style::kPaperCurve, "", Role::baseline});
  constexpr std::size_t kPanels = 3;
  const std::vector<CurvePanel> panels = {error_panel(table), time_panel(table), iteration_panel(table)};
  PanelGrid grid =
      panel_grid(kPanels, methods, options.size, options.size == FigureSize::single ? 1 : kPanels,
                 has_flaws(panels) ? "some solves failed or wrong" : "");
  grid.gap = 0.45;
  grid.x_labels = 0.2;
  return draw_curve_panels(grid, panels, methods, "tolerance ε", "");
}

}  // namespace

Drawing figure5(const std::vector<Record>& records, const FigureOptions& options) {
  return example1_figure("fig5", records, Example1Roles::cone_ellipsoid, options);
}

Drawing figure7(const std::vector<Record>& records, const FigureOptions& options) {
  return example1_figure("fig7", records, Example1Roles::ellipsoid_cone, options);
}

}  // namespace raygauge
