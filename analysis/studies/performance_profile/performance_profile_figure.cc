// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/performance_profile/performance_profile_figure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/figures/panel_grid.h"
#include "analysis/render/figures/style.h"
#include "analysis/studies/performance_profile/performance_profile.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

constexpr const char* kProfileName = "performance_profile";

std::string profile_block(const ProfileCurve& curve, std::size_t index, double last) {
  constexpr std::size_t kMostSteps = 1000;
  std::string text = "$profile" + std::to_string(index) + " << EOD\n";
  for (const auto& [tau, rho] : curve.steps(last, kMostSteps))
    text += rounded_text(tau, 6) + " " + rounded_text(rho, 6) + "\n";
  return text + "EOD\n";
}

}  // namespace

Drawing performance_profile_figure(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(kProfileName, records, options.filter);
  const std::vector<ProfileCurve> curves = performance_profiles(kept);
  if (curves.size() < 2) {
    throw FigureNeedsError(std::string("figure ") + kProfileName + " needs records of two or more methods");
  }
  const MethodList methods = methods_of(kept);
  const double last = profile_end(curves);
  constexpr double kLabelled = 0.97;  // of the axis: a number at its very end would stick out
  const PanelGrid grid = panel_grid(1, methods, options.size, 1);
  Drawing drawing;
  drawing.width = grid.width;
  drawing.height = grid.height();
  std::string plots;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    drawing.script += profile_block(curves[i], i, last);
    plots += (i == 0 ? "plot " : ", \\\n  ") + ("$profile" + std::to_string(i)) + " using 1:2 with steps " +
             figure_style::step_style(curves[i].method, methods);
  }
  drawing.script += "set multiplot\nset logscale x\nset xrange [1:" + rounded_text(last, 6) +
                    "]\nset yrange [0:1.02]\n" +
                    grid.axis_labels("time over the fastest method''s, τ", "share of instances solved") +
                    grid.legend_plot(methods) + grid.margins(0) + "set xtics nomirror " +
                    figure_style::one_two_five_ticks(1, std::pow(last, kLabelled)) +
                    "\nset ytics nomirror 0.2\n" + plots + "\nunset multiplot\n";
  return drawing;
}

}  // namespace raygauge
