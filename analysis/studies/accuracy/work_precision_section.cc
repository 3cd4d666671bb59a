// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "analysis/constants.h"
#include "analysis/data/truth.h"
#include "analysis/studies/accuracy/accuracy.h"
#include "analysis/studies/accuracy/tolerance_groups.h"
#include "analysis/studies/sections.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

/// The point of one tolerance as the figure work_precision has it; y is NaN where there is none.
ChartPoint work_point(const std::vector<const Record*>& records, const Truth& truth) {
  constexpr double kInMilliseconds = 1e3;
  constexpr double kExact = 1e-17;  // a logarithmic axis has no 0
  const AccuracyPoint point = accuracy_curves(records, truth).front().points.front();
  const bool known = !std::isnan(point.largest_relative_error);
  const double error = known ? point.mean_relative_error : point.mean_relative_gap;
  if (!std::isfinite(error)) return {kNaN, kNaN, kNaN, kNaN, ""};
  std::vector<double> seconds;
  for (const Record* record : records) seconds.push_back(record->seconds);
  const Interval interval = median_interval(seconds);
  std::string remark = "ε = " + rounded_text(point.tolerance, 3) + ", times [" + time_words(interval.lower) +
                       ", " + time_words(interval.upper) + "]";
  if (point.failures > 0) remark += ", " + std::to_string(point.failures) + " failed";
  if (point.wrong > 0) remark += ", " + std::to_string(point.wrong) + " wrong";
  return {kInMilliseconds * point.median_seconds, std::max(error, kExact), kNaN, kNaN, remark,
          point.failures + point.wrong > 0};
}

}  // namespace

std::optional<Section> work_precision_section(const Input& input) {
  Chart chart;
  chart.caption =
      "Work–precision: mean error of the answers against the median time, one point for each tolerance. The "
      "error is |d - true d| / true d where the truth is known, else the certified (upper - lower) / upper; "
      "0 is drawn at 1e-17. A crossed point: some solves failed or were wrong.";
  chart.x = {"median time of a solve (ms)", true, "ms"};
  chart.y.label = "mean relative error";
  for (const ToleranceCurve& curve : tolerance_curves(input.groups)) {
    Series series{curve.method, "", curve.facets, {}};
    for (const auto& [tolerance, records] : curve.records) {
      const ChartPoint point = work_point(records, input.truth);
      if (point.y > 0) series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  if (chart.series.empty()) return std::nullopt;
  Section section{"work_precision", "Work and precision", {}};
  section.blocks.emplace_back(chart);
  return section;
}

}  // namespace raygauge::report
