// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "analysis/constants.h"
#include "analysis/data/columns.h"
#include "analysis/statistics/statistics.h"
#include "analysis/studies/accuracy/tolerance_groups.h"
#include "analysis/studies/sections.h"

namespace raygauge::report {
namespace {

Series mean_series(const ToleranceCurve& curve, const AnalysisColumn& column) {
  Series series{curve.method, "", curve.facets, {}};
  for (const auto& [tolerance, records] : curve.records) {
    std::vector<double> values;
    for (const Record* record : records) values.push_back(number_of(column, *record));
    const double average = mean(values);
    if (average > 0) series.points.push_back({tolerance, average, kNaN, kNaN, ""});
  }
  return series;
}

}  // namespace

std::optional<Section> iterations_section(const Input& input) {
  Section section{"iterations", "Iterations against the tolerance", {}};
  const std::vector<ToleranceCurve> curves = tolerance_curves(input.groups);
  for (const char* name : {"K", "N_rs"}) {
    const AnalysisColumn& column = analysis_column(name);
    Chart chart;
    chart.caption = std::string("Mean ") + name + " (" + column.description + ") against the tolerance ε.";
    chart.x.label = "ε";
    chart.y = {std::string("mean ") + name, false, ""};
    for (const ToleranceCurve& curve : curves) {
      Series series = mean_series(curve, column);
      if (series.points.size() > 1) chart.series.push_back(std::move(series));
    }
    if (!chart.series.empty()) section.blocks.emplace_back(chart);
  }
  if (section.blocks.empty()) return std::nullopt;
  return section;
}

}  // namespace raygauge::report
