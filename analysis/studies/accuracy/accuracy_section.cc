// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/accuracy_tables.h"

#include <algorithm>
#include <cmath>

#include "analysis/render/report/blocks.h"
#include "analysis/studies/sections.h"

namespace raygauge::report {
namespace {

bool is_known(const AccuracyGroup& group) {
  return std::any_of(group.curves.begin(), group.curves.end(), [](const AccuracyCurve& curve) {
    return curve.points.size() > 1 && !std::isnan(curve.points.front().largest_relative_error);
  });
}

}  // namespace

std::optional<Section> accuracy_section(const Input& input) {
  std::vector<AccuracyGroup> groups = accuracy_groups(input.groups, input.truth);
  groups.erase(std::remove_if(groups.begin(), groups.end(), std::not_fn(is_known)), groups.end());
  if (groups.empty()) return std::nullopt;
  std::vector<Table> tables = accuracy_tables(groups);
  // Of many groups only the last table, which has a line for each of them, can be read.
  constexpr std::size_t kMostGroups = 6;
  if (groups.size() > kMostGroups) tables.erase(tables.begin(), std::prev(tables.end()));
  Section section{"accuracy", "Accuracy", {}};
  for (const Table& table : tables) section.blocks.emplace_back(table);
  return section;
}

}  // namespace raygauge::report
