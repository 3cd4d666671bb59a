// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/report/blocks.h"
#include "analysis/studies/example1/example1_table.h"
#include "analysis/studies/sections.h"

namespace raygauge::report {

std::optional<Section> example1_section(const Input& input) {
  Section section{"example1", "Example 1 beside the paper", {}};
  for (const Example1Roles roles : {Example1Roles::cone_ellipsoid, Example1Roles::ellipsoid_cone}) {
    const Example1Table table = example1_table_of(input.groups, roles, input.truth);
    if (table.curves.empty()) continue;
    for (const Table& each : example1_tables(table)) section.blocks.emplace_back(each);
  }
  if (section.blocks.empty()) return std::nullopt;
  return section;
}

}  // namespace raygauge::report
