// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/stability/wrong_share.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/constants.h"
#include "analysis/render/figures/curve_panel.h"
#include "analysis/render/figures/style.h"
#include "analysis/render/time_unit.h"
#include "engine/numerics/number_text.h"
#include "engine/sweep/agreement.h"

namespace raygauge {
namespace {

/// What the point of a method is made of.
struct MethodShare {
  std::vector<double> seconds;  ///< of all its records
  std::size_t answers = 0, wrong = 0;

  bool has_point() const { return answers > 0 && std::isfinite(median(seconds)); }
};

MethodShare share_of(const std::string& method, const std::vector<Record>& records) {
  MethodShare share;
  for (const Record& record : records) {
    if (record.method != method) continue;
    share.seconds.push_back(time_or_infinity(record));
    if (!is_solved(record)) continue;
    ++share.answers;
    if (!record.agrees) ++share.wrong;
  }
  return share;
}

}  // namespace

Interval share_interval(std::size_t k, std::size_t n) {
  if (n == 0 || k > n) throw InvalidParameterError("a share is of one trial at least, and at most 1");
  constexpr double kNormal = 1.959963984540054;  // its quantile of order 0.975
  const auto trials = static_cast<double>(n);
  const double p = static_cast<double>(k) / trials, z2 = kNormal * kNormal;
  const double middle = p + z2 / (2 * trials);
  const double half = kNormal * std::sqrt(p * (1 - p) / trials + z2 / (4 * trials * trials));
  const double whole = 1 + z2 / trials;
  return {k == 0 ? 0 : (middle - half) / whole, k == n ? 1 : (middle + half) / whole, 0.95};
}

Drawing wrong_share(const std::vector<Record>& records, const FigureOptions& options) {
  std::vector<Record> kept = figure_style::comparable_records("wrong_share", records, options.filter);
  std::erase_if(kept, [](const Record& record) { return record.role == Role::oracle; });
  const MethodList methods = methods_of(kept);
  std::vector<std::pair<std::string, MethodShare>> shares;
  std::size_t wrong = 0;
  double fastest = kInfinity, slowest = 0;
  for (const std::string& method : methods) {
    MethodShare share = share_of(method, kept);
    wrong += share.wrong;
    if (!share.has_point()) continue;
    fastest = std::min(fastest, median(share.seconds));
    slowest = std::max(slowest, median(share.seconds));
    shares.emplace_back(method, std::move(share));
  }
  if (shares.empty() || wrong == 0)
    throw FigureNeedsError("figure wrong_share needs answers that do not agree with a proof");
  constexpr double kPerCent = 100;
  const TimeUnit unit = time_unit_for(fastest, slowest);
  CurvePanel panel;
  for (const auto& [method, share] : shares) {
    const double x = unit.per_second * median(share.seconds);
    const Interval interval = share_interval(share.wrong, share.answers);
    PanelCurve curve{method, {}, {}, {}};
    curve.points.emplace_back(
        x, kPerCent * static_cast<double>(share.wrong) / static_cast<double>(share.answers));
    curve.bars.emplace_back(kPerCent * interval.lower, kPerCent * interval.upper);
    panel.curves.push_back(std::move(curve));
  }
  const auto [left, right] = range_of(panel.curves, false, 1.3);
  const double top = range_of(panel.curves, true, 1.05).second;
  panel.settings = "set logscale x\n" + range_setting("x", left, right) + range_setting("y", 0, top) +
                   "set format x '%g'\nset format y '%g'\nset xtics nomirror " +
                   figure_style::one_two_five_ticks(left, right) + "\nset ytics nomirror\n";
  const PanelGrid grid = panel_grid(1, methods, options.size, 1);
  return draw_curve_panels(grid, {panel}, methods, std::string("median time of a solve, ") + unit.name,
                           "wrong answers, %");
}

}  // namespace raygauge
