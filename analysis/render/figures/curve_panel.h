// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/data/method_list.h"
#include "analysis/render/figures/figure.h"
#include "analysis/render/figures/panel_grid.h"

namespace raygauge {

/// A method's points (x, y), joined in their order.
struct PanelCurve {
  std::string method;
  std::vector<std::pair<double, double>> points;
  std::vector<std::pair<double, double>> bars;  ///< the ends of each point's interval; none where empty
  std::vector<std::pair<double, double>>
      flaws;  ///< points that are crossed; what it means is PanelGrid::flaw
};

/// A panel of curves.
struct CurvePanel {
  std::string title;
  std::string settings;    ///< gnuplot: scales, ranges and tics
  std::string background;  ///< gnuplot: what is plotted below the curves, "" for nothing
  std::vector<PanelCurve> curves;
};

/// Whether a point of a curve is crossed.
bool has_flaws(const std::vector<CurvePanel>& panels);

/// The figure of the panels, `grid` being laid out for them, under a legend of `methods`.
Drawing draw_curve_panels(const PanelGrid& grid, const std::vector<CurvePanel>& panels,
                          const MethodList& methods, const std::string& x, const std::string& y);

/// The least and the largest x of all points (y with `of_y`, bars included), widened by a factor; {1, 10}
/// without points.
std::pair<double, double> range_of(const std::vector<PanelCurve>& curves, bool of_y, double factor);

/// Where a relative error is drawn on error_axis(): those below 1e-17 at "0", those above 100 at "∞".
double drawn_error(double error);

/// gnuplot's logarithmic y axis of errors from "0" over powers of ten to "∞", labelled or not.
std::string error_axis(bool labelled);

/// "set NAMErange [a:b]\n"
std::string range_setting(const char* name, double from, double to);

}  // namespace raygauge
