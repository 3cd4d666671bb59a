// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "analysis/render/report/blocks.h"
#include "analysis/studies/crossover/crossover.h"
#include "analysis/studies/sections.h"
#include "results/text/number_words.h"

namespace raygauge::report {

std::optional<Section> crossover_section(const Input& input) {
  if (input.methods.size() < 2) return std::nullopt;
  HeatMap map;
  map.caption =
      "The method with the smallest median time in each cell, and how many times longer the second takes on "
      "the "
      "same instances (median). \"?\": the 95 % interval of that number includes 1.";
  map.row_label = "n";
  map.column_label = "N";
  for (const CellWinner& winner : cell_winners(input.instances)) {
    HeatCell cell;
    cell.facets = problem_facets(winner.cell);
    cell.row = winner.cell.n;
    cell.column = winner.cell.N;
    cell.value = winner.lead.ratio;
    cell.group = winner.method;
    cell.text = winner.runner_up.empty() ? "only" : padded_significant(winner.lead.ratio, 2) + "×";
    if (!winner.runner_up.empty() && !winner.decided) cell.text += "?";
    cell.remark = winner.method + " " + time_words(winner.seconds);
    if (!winner.runner_up.empty()) {
      cell.remark +=
          "; " + winner.runner_up + " takes " +
          interval_words(winner.lead.ratio, winner.lead.interval.lower, winner.lead.interval.upper) +
          " times as long";
    }
    map.cells.push_back(std::move(cell));
  }
  if (map.cells.empty()) return std::nullopt;
  Section section{"crossover", "Who wins where", {}};
  section.blocks.emplace_back(map);
  return section;
}

}  // namespace raygauge::report
