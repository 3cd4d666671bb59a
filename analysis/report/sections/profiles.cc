// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/constants.h"
#include "analysis/performance_profile.h"
#include "analysis/report/blocks.h"
#include "analysis/report/sections/sections.h"

namespace raygauge::report {
namespace {

constexpr std::size_t kMostPoints = 400;  // finer steps than pixels

Series profile_series(const ProfileCurve& curve, double last, const Facets& facets) {
  Series series{curve.method, "", facets, {}};
  const auto point = [&](double tau) { series.points.push_back({tau, curve.rho(tau), kNaN, kNaN, ""}); };
  point(1);
  const std::size_t stride = std::max<std::size_t>(1, curve.ratios.size() / kMostPoints);
  for (std::size_t i = stride - 1; i < curve.ratios.size(); i += stride) point(curve.ratios[i]);
  if (!curve.ratios.empty()) point(curve.ratios.back());
  point(last);
  return series;
}

}  // namespace

std::optional<Section> profiles_section(const Input& input) {
  if (methods_of(input.records).size() < 2) return std::nullopt;
  std::map<Facets, std::vector<Record>> problems;
  for (const Record& record : input.records) problems[problem_facets(cell_key(record))].push_back(record);
  Chart chart;
  chart.caption =
      "Performance profiles of Dolan and Moré: the share of all instances that a method solves within τ "
      "times "
      "the time of the fastest method on that instance. Limits, failures and disagreements count as "
      "unsolved.";
  chart.x.label = "τ, time over the fastest method's";
  chart.y = {"share of instances", false};
  chart.stepped = true;
  for (const auto& [facets, records] : problems) {
    const std::vector<ProfileCurve> curves = performance_profiles(records);
    double last = 2;
    for (const ProfileCurve& curve : curves) {
      if (!curve.ratios.empty()) last = std::max(last, 1.1 * curve.ratios.back());
    }
    for (const ProfileCurve& curve : curves) chart.series.push_back(profile_series(curve, last, facets));
  }
  Section section{"profiles", "Performance profiles", {}};
  section.blocks.push_back(chart_block(chart));
  return section;
}

}  // namespace raygauge::report
