// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/true_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "analysis/data/truth.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/studies/table3/cell_ratio.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

constexpr const char* kTrueErrorName = "true_error";

/// The largest error at each value of one family's hardness, see Hardness.
struct Family {
  std::string hardness;
  std::set<double> values;
  std::map<std::string, std::map<double, double>> worst;  ///< by method and value
};

/// The families that have a parameter of hardness, by name.
std::map<std::string, Family> families_with_hardness(const std::vector<Record>& records, const Truth& truth) {
  std::map<std::string, Family> families;
  for (const Record& record : records) {
    const double error = true_error(record, truth(record));
    if (std::isnan(error) || std::isnan(record.hardness)) continue;
    Family& family = families[record.generator];
    family.hardness = record.hardness_label;
    family.values.insert(record.hardness);
    double& worst = family.worst[record.method].try_emplace(record.hardness, error).first->second;
    worst = std::max(worst, error);
  }
  return families;
}

CurvePanel family_panel(const std::string& name, const Family& family, const MethodList& methods,
                        double tolerance) {
  CurvePanel panel;
  panel.title = name + ": " + family.hardness;
  panel.background = rounded_text(10 * tolerance, 6) + " with lines lc rgb '#8C8C8C' lw 0.8 dt 1";
  for (const std::string& method : methods) {
    const auto found = family.worst.find(method);
    if (found == family.worst.end()) continue;
    PanelCurve curve{method, {}, {}, {}};
    for (const auto& [x, error] : found->second) curve.points.emplace_back(x, drawn_error(error));
    panel.curves.push_back(std::move(curve));
  }
  const double margin = std::pow(*family.values.rbegin() / *family.values.begin(), 0.05);
  const double low = *family.values.begin() / margin;
  const double high = *family.values.rbegin() * margin;
  panel.settings = "set logscale x\n" + range_setting("x", low, high) + "set xtics nomirror " +
                   figure_style::decade_ticks(low, high) + "\n";
  return panel;
}

}  // namespace

Drawing true_error_figure(const std::vector<Record>& records, const FigureOptions& options) {
  std::vector<Record> kept =
      figure_style::comparable_records(kTrueErrorName, records, options.filter, {"tolerance"});
  kept.erase(
      std::remove_if(kept.begin(), kept.end(), [](const Record& each) { return each.role == Role::oracle; }),
      kept.end());
  const MethodList methods = methods_of(kept);
  std::vector<CurvePanel> panels;
  for (const auto& [name, family] : families_with_hardness(kept, Truth(records))) {
    if (family.values.size() > 1)
      panels.push_back(family_panel(name, family, methods, kept.front().tolerance));
  }
  if (panels.empty()) {
    throw FigureNeedsError(std::string("figure ") + kTrueErrorName +
                           " needs answers of known truth at two or more values of a generator's measure of "
                           "hardness, as aspect or 1/delta");
  }
  PanelGrid grid =
      panel_grid(panels.size(), methods, options.size, options.size == FigureSize::single ? 2 : 3);
  grid.x_labels = 0.2;
  for (std::size_t p = 0; p < panels.size(); ++p) panels[p].settings += error_axis(grid.is_left(p));
  return draw_curve_panels(grid, panels, methods, "conditioning or scale", "largest true error");
}

}  // namespace raygauge
