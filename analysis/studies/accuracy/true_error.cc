// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/true_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/pool.h"
#include "analysis/data/truth.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

constexpr const char* kTrueErrorName = "true_error";

/// The largest error at each value of one family's hardness, see Hardness; where that is infinite, it stands
/// at +infinity.
struct Family {
  std::string hardness;
  std::set<double> values;
  std::map<std::string, std::map<double, double>> worst;  ///< by method and value
};

/// The families that have a parameter of hardness, by tolerance and name.
using Families = std::map<std::pair<double, std::string>, Family>;

Families families_with_hardness(const std::vector<Record>& records, const Truth& truth) {
  Families families;
  for (const Record& record : records) {
    const double error = true_error(record, truth(record));
    if (std::isnan(error) || !(record.hardness > 0)) continue;
    Family& family = families[{record.tolerance, record.generator}];
    family.hardness = record.hardness_label;
    family.values.insert(record.hardness);
    double& worst = family.worst[record.method].try_emplace(record.hardness, error).first->second;
    worst = std::max(worst, error);
  }
  std::erase_if(families, [](const auto& each) { return each.second.values.size() < 2; });
  return families;
}

/// Where a family's values stand: infinity has a place behind the others, as far as a fifth of the axis.
class HardnessAxis {
 public:
  explicit HardnessAxis(const std::set<double>& values) : low_(*values.begin()) {
    const bool has_infinite = std::isinf(*values.rbegin());
    last_ = has_infinite ? *std::next(values.rbegin()) : *values.rbegin();
    constexpr double kBehind = 0.25;
    constexpr double kAlone = 10;
    high_ = last_;
    if (has_infinite) high_ *= last_ > low_ ? std::pow(last_ / low_, kBehind) : kAlone;
  }

  double place(double value) const { return std::isinf(value) ? high_ : value; }

  std::string settings() const {
    const double margin = std::pow(high_ / low_, 0.05);
    std::string ticks = figure_style::decade_ticks(low_ / margin, high_ > last_ ? last_ : high_ * margin);
    if (high_ > last_)
      ticks.insert(ticks.size() - 1, (ticks == "()" ? "'∞' " : ", '∞' ") + rounded_text(high_, 6));
    return "set logscale x\n" + range_setting("x", low_ / margin, high_ * margin) + "set xtics nomirror " +
           ticks + "\n";
  }

 private:
  double low_;
  double last_;  ///< of the finite values
  double high_;
};

CurvePanel family_panel(const std::string& title, double tolerance, const Family& family,
                        const MethodList& methods) {
  CurvePanel panel;
  panel.title = title;
  panel.background = rounded_text(10 * tolerance, 6) + " with lines lc rgb '#8C8C8C' lw 0.8 dt 1";
  const HardnessAxis axis(family.values);
  for (const std::string& method : methods) {
    const auto found = family.worst.find(method);
    if (found == family.worst.end()) continue;
    PanelCurve curve{method, {}, {}, {}};
    for (const auto& [x, error] : found->second) curve.points.emplace_back(axis.place(x), drawn_error(error));
    panel.curves.push_back(std::move(curve));
  }
  panel.settings = axis.settings();
  return panel;
}

std::vector<CurvePanel> family_panels(const Families& families, const MethodList& methods) {
  const bool one_tolerance =
      families.empty() || families.begin()->first.first == families.rbegin()->first.first;
  std::vector<CurvePanel> panels;
  for (const auto& [key, family] : families) {
    const auto& [tolerance, name] = key;
    const std::string where = one_tolerance ? "" : ", ε = " + rounded_text(tolerance, 3);
    panels.push_back(family_panel(name + ": " + family.hardness + where, tolerance, family, methods));
  }
  return panels;
}

}  // namespace

Drawing true_error_figure(const std::vector<Record>& records, const FigureOptions& options) {
  std::vector<Record> kept = figure_style::comparable_records(kTrueErrorName, records, options.filter);
  std::erase_if(kept, [](const Record& each) { return each.role == Role::oracle; });
  const MethodList methods = methods_of(kept);
  std::vector<CurvePanel> panels =
      family_panels(families_with_hardness(kept, Pool(records).truth_of(records)), methods);
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
