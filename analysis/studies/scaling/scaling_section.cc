// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "analysis/render/report/blocks.h"
#include "analysis/studies/scaling/scaling.h"
#include "analysis/studies/sections.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

constexpr std::size_t kFewest = 3;  // sizes that leave a fit an interval

const char* size_name(SizeAxis axis) { return axis == SizeAxis::n ? "n" : "N"; }

Facets curve_facets(const ScalingCurve& curve, SizeAxis axis) {
  Facets facets = problem_facets(curve.cell);
  if (axis == SizeAxis::N) {
    facets.emplace_back("n", std::to_string(curve.cell.n));
  } else {
    facets.emplace_back("N", std::to_string(curve.cell.N));
  }
  return facets;
}

Series series_of(const ScalingCurve& curve, SizeAxis axis, double per_second) {
  Series series{curve.method, "", curve_facets(curve, axis), {}};
  if (curve.sizes.size() >= kFewest) {
    const PowerLaw fit = fit_scaling(curve);
    series.name = curve.method + " (exponent " + padded_significant(fit.exponent, 2) + ")";
  }
  for (std::size_t i = 0; i < curve.sizes.size(); ++i) {
    std::string remark = std::to_string(curve.counts[i]) + " times";
    if (curve.outliers[i] > 0) remark += ", " + std::to_string(curve.outliers[i]) + " outliers";
    if (curve.unsolved[i] > 0) remark += ", " + std::to_string(curve.unsolved[i]) + " unsolved";
    if (curve.disagreeing[i] > 0)
      remark += ", " + std::to_string(curve.disagreeing[i]) + " more left out: wrong answers";
    series.points.push_back({curve.sizes[i], per_second * curve.medians[i],
                             per_second * curve.intervals[i].lower, per_second * curve.intervals[i].upper,
                             remark, curve.unsolved[i] + curve.disagreeing[i] > 0});
  }
  return series;
}

Table exponents_table(const std::vector<ScalingCurve>& curves, SizeAxis axis) {
  const std::string size = size_name(axis);
  Table table;
  table.title = "time = factor · " + size + "^exponent";
  table.header = {
      {"problem", "tolerance", axis == SizeAxis::n ? "N" : "n", "method", "exponent", "R²", "points"}};
  table.key_columns = 4;
  for (const ScalingCurve& curve : curves) {
    if (curve.sizes.size() < kFewest) continue;
    const PowerLaw fit = fit_scaling(curve);
    const Facets facets = curve_facets(curve, axis);
    table.rows.push_back(
        {{{facets[0].second},
          {facets[1].second},
          {facets[2].second},
          {curve.method},
          {interval_words(fit.exponent, fit.exponent_interval.lower, fit.exponent_interval.upper),
           Emphasis::strong},
          {padded_significant(fit.r_squared, 3)},
          {std::to_string(fit.points)}}});
  }
  table.notes = {"least squares of the logarithms of the medians; 95 % intervals of Student's t"};
  return table;
}

void add_axis(const Input& input, SizeAxis axis, Section& section) {
  const std::vector<ScalingCurve> curves = scaling_curves(input.cells, input.methods, axis);
  if (curves.empty()) return;
  Chart chart;
  const std::string center = center_words(curves);
  chart.caption = (center == "median" ? "Median" : "Typical") + std::string(" time of a solve against ") +
                  size_name(axis) + (center == "median" ? "" : ", the " + center) +
                  "; bars: 95 % intervals, of medians by order statistics. A crossed point: some answers are "
                  "wrong or missing.";
  chart.x.label = axis == SizeAxis::n ? "n, dimension" : "N, points in each set";
  const TimeUnit unit = unit_of(curves);
  chart.y.label = center + " time of a solve (" + unit.name + ")";
  chart.y.unit = unit.name;
  for (const ScalingCurve& curve : curves) chart.series.push_back(series_of(curve, axis, unit.per_second));
  section.blocks.emplace_back(chart);
  const Table exponents = exponents_table(curves, axis);
  if (!exponents.rows.empty()) section.blocks.emplace_back(exponents);
}

}  // namespace

std::optional<Section> scaling_section(const Input& input) {
  Section section{"scaling", "Time against size", {}};
  add_axis(input, SizeAxis::N, section);
  add_axis(input, SizeAxis::n, section);
  if (section.blocks.empty()) return std::nullopt;
  return section;
}

}  // namespace raygauge::report
