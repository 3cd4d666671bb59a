// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/wrong_share.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/constants.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/render/time_unit.h"
#include "analysis/studies/stability/wrong_share.h"
#include "analysis/studies/wrong_answers/wrong_answers.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

constexpr double kNone = 1e-6;  // where a share of 0 is drawn, on a logarithmic axis

std::string share_axis(bool labelled) {
  std::string ticks;
  for (const auto& [label, place] : {std::pair{"0", kNone},
                                     {"0.001", 1e-5},
                                     {"0.01", 1e-4},
                                     {"0.1", 1e-3},
                                     {"1", 1e-2},
                                     {"10", 1e-1},
                                     {"100", 1.0}}) {
    ticks +=
        (ticks.empty() ? "'" : ", '") + std::string(labelled ? label : "") + "' " + rounded_text(place, 1);
  }
  return "set logscale y\nset yrange [5e-7:2]\nset ytics nomirror (" + ticks + ")\n";
}

std::string panel_title(const WrongInPlace& part, bool several_tolerances) {
  const std::string about =
      part.quantity == Quantity::distance ? "" : std::string(to_string(part.quantity)) + ", ";
  const std::string place = about + (part.place.empty() ? "all places" : part.place);
  return several_tolerances ? place + ", ε = " + rounded_text(part.tolerance, 3) : place;
}

std::vector<PanelCurve> points_of(const WrongInPlace& part, const TimeUnit& unit) {
  std::vector<PanelCurve> curves;
  for (const WrongAnswers& row : part.methods) {
    if (std::isinf(row.median_seconds)) continue;
    const std::pair<double, double> point(unit.per_second * row.median_seconds,
                                          std::max(row.wrong_share(), kNone));
    PanelCurve curve{row.method, {point}, {}, {}};
    if (row.gave_up + row.limits > 0) curve.flaws.push_back(point);
    curves.push_back(std::move(curve));
  }
  return curves;
}

TimeUnit unit_of(const WrongStudy& study) {
  double least = kInfinity, most = 0;
  for (const WrongInPlace& part : study.places) {
    for (const WrongAnswers& row : part.methods) {
      if (std::isinf(row.median_seconds)) continue;
      least = std::min(least, row.median_seconds);
      most = std::max(most, row.median_seconds);
    }
  }
  return time_unit_for(least, most);
}

std::string time_axis(const std::vector<PanelCurve>& curves) {
  const auto [low, high] = range_of(curves, false, 1.4);
  return "set logscale x\n" + range_setting("x", low, high) + "set format x '%g'\nset xtics nomirror " +
         figure_style::one_two_five_ticks(low, high) + "\n";
}

Drawing wrong_share_by_place(const WrongStudy& study, const FigureOptions& options) {
  const TimeUnit unit = unit_of(study);
  const bool several = study.places.front().tolerance != study.places.back().tolerance;
  std::vector<CurvePanel> panels;
  for (const WrongInPlace& part : study.places) {
    CurvePanel panel{panel_title(part, several), "", "", points_of(part, unit)};
    panel.settings = time_axis(panel.curves);
    panels.push_back(std::move(panel));
  }
  PanelGrid grid =
      panel_grid(panels.size(), study.methods, options.size, options.size == FigureSize::single ? 1 : 3,
                 has_flaws(panels) ? "some solves without an answer" : "");
  grid.x_labels = 0.2;
  for (std::size_t p = 0; p < panels.size(); ++p) panels[p].settings += share_axis(grid.is_left(p));
  return draw_curve_panels(grid, panels, study.methods, std::string("median time of a solve, ") + unit.name,
                           "wrong answers, %");
}

}  // namespace

Drawing wrong_share_figure(const std::vector<Record>& records, const FigureOptions& options) {
  WrongStudy study;
  try {
    study = wrong_answers(records, options.filter);
  } catch (const EmptySetError&) {
    return wrong_share(records, options);
  }
  return wrong_share_by_place(study, options);
}

}  // namespace raygauge
