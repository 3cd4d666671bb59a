// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "analysis/data/truth.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/sections.h"
#include "analysis/studies/stability/stability.h"

namespace raygauge::report {

std::optional<Section> stability_section(const Input& input) {
  const bool known = std::any_of(input.records.begin(), input.records.end(),
                                 [&](const Record& record) { return !std::isnan(input.truth(record)); });
  if (!known) return std::nullopt;
  Section section{"stability", "Stability", {}};
  for (const Table& table : stability_tables(make_stability(input.records, input.truth)))
    section.blocks.push_back(table);
  return section;
}

}  // namespace raygauge::report
