// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/constants.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/performance_profile/performance_profile.h"
#include "analysis/studies/sections.h"

namespace raygauge::report {
namespace {

constexpr std::size_t kMostPoints = 400;  // finer steps than pixels

Series profile_series(const ProfileCurve& curve, double last, const Facets& facets) {
  Series series{curve.method, "", facets, {}};
  for (const auto& [tau, rho] : curve.steps(last, kMostPoints))
    series.points.push_back({tau, rho, kNaN, kNaN, ""});
  return series;
}

}  // namespace

std::optional<Section> profiles_section(const Input& input) {
  if (input.methods.size() < 2) return std::nullopt;
  std::map<Facets, std::vector<const std::vector<MethodInstances>*>> problems;
  for (const auto& [cell, instances] : input.instances) problems[problem_facets(cell)].push_back(&instances);
  Chart chart;
  chart.caption =
      "Performance profiles of Dolan and Moré: the share of all instances that a method solves within τ "
      "times "
      "the time of the fastest method on that instance. Limits, failures and disagreements count as "
      "unsolved.";
  chart.x.label = "τ, time over the fastest method's";
  chart.y = {"share of instances", false, ""};
  chart.stepped = true;
  for (const auto& [facets, cells] : problems) {
    const std::vector<ProfileCurve> curves = performance_profiles(cells, input.methods);
    const double last = profile_end(curves);
    for (const ProfileCurve& curve : curves) chart.series.push_back(profile_series(curve, last, facets));
  }
  Section section{"profiles", "Performance profiles", {}};
  section.blocks.emplace_back(chart);
  return section;
}

}  // namespace raygauge::report
