// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "analysis/columns.h"
#include "analysis/number_text.h"
#include "analysis/report/sections/sections.h"
#include "analysis/report/sections/tolerance_groups.h"
#include "analysis/truth.h"

namespace raygauge::report {
namespace {

/// What a record's answer is off by: its true error where the truth is known, else what its bounds prove.
double attained_error(const Record& record, const Truth& truth) {
  const double error = true_error(record, truth(record));
  return std::isnan(error) ? relative_gap(record) : error;
}

ChartPoint work_point(double tolerance, const std::vector<const Record*>& records, const Truth& truth) {
  constexpr double kInMilliseconds = 1e3;
  constexpr double kExact = 1e-17;  // a logarithmic axis has no 0
  std::vector<double> errors;
  std::vector<double> milliseconds;
  for (const Record* record : records) {
    if (!record->agrees) continue;
    milliseconds.push_back(kInMilliseconds * time_or_infinity(*record));
    const double error = attained_error(*record, truth);
    if (is_solved(*record) && std::isfinite(error)) errors.push_back(std::max(error, kExact));
  }
  if (errors.empty() || !std::isfinite(median(milliseconds))) return {};
  const Interval interval = median_interval(milliseconds);
  return {median(errors), median(milliseconds), interval.lower, interval.upper,
          "ε = " + significant(tolerance, 3)};
}

}  // namespace

std::optional<Section> work_precision_section(const Input& input) {
  const Truth truth(input.all_records);
  Chart chart;
  chart.caption =
      "Work–precision: median time against the median error that was attained, one point for each tolerance. "
      "The "
      "error is |d - true d| / true d where the truth is known, else the certified (upper - lower) / upper; "
      "0 is drawn at "
      "1e-17. Bars: 95 % order-statistic intervals of the medians.";
  chart.x.label = "median relative error";
  chart.y.label = "median time (ms)";
  for (const ToleranceCurve& curve : tolerance_curves(input.records)) {
    Series series{curve.method, "", curve.facets, {}};
    for (const auto& [tolerance, records] : curve.records) {
      const ChartPoint point = work_point(tolerance, records, truth);
      if (point.y > 0) series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  if (chart.series.empty()) return std::nullopt;
  Section section{"work_precision", "Work and precision", {}};
  section.blocks.push_back(chart_block(chart));
  return section;
}

}  // namespace raygauge::report
