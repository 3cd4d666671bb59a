// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "analysis/render/report/blocks.h"
#include "analysis/studies/sections.h"
#include "analysis/studies/table3/table3.h"
#include "analysis/studies/table3/table3_tables.h"
#include "raygauge/exceptions.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge::report {
namespace {

HeatCell ratio_cell(const CellRatio& ratio) {
  HeatCell cell;
  cell.facets = problem_facets(ratio.times.cell);
  cell.facets.emplace_back("method", ratio.times.method);
  cell.row = ratio.times.cell.n;
  cell.column = ratio.times.cell.N;
  cell.value = ratio.ratio.ratio;
  cell.text = std::isfinite(cell.value) ? padded_significant(cell.value, 2) : "-";
  if (ratio.times.unsolved + ratio.times.disagreeing > 0) cell.text += "!";
  cell.remark = time_words(ratio.median_seconds) + ", " + ratio.baseline + " " +
                time_words(ratio.baseline_seconds) + "; ratio " +
                interval_words(ratio.ratio.ratio, ratio.ratio.interval.lower, ratio.ratio.interval.upper) +
                "; " + std::to_string(ratio.times.unsolved) + " unsolved, " +
                std::to_string(ratio.times.disagreeing) + " disagreeing";
  return cell;
}

/// Table III, where the records are of Example 2 at its tolerance.
void add_table3(const Input& input, Section& section) {
  try {
    for (const Record& record : input.records) {
      if (record.generator != "example2") continue;
      for (const Table& table :
           table3_tables(make_table3(input.merged.records, input.filter, input.baselines)))
        section.blocks.emplace_back(table);
      return;
    }
  } catch (const Error&) {
    // Other tolerances, or several parameters: the map above has shown what there is.
  }
}

}  // namespace

std::optional<Section> ratios_section(const Input& input) {
  if (input.baselines.empty()) return std::nullopt;
  HeatMap map;
  std::vector<CellKey> cells;
  for (const CellRatio& ratio : input.ratios) cells.push_back(ratio.times.cell);
  map.caption = "Ratio of " + center_words(cells) + " times: method over the best of " +
                joined(input.baselines) +
                " in the cell. Below 1 the method is faster. 95 % intervals are those of independent "
                "medians. \"!\" marks "
                "cells with unsolved or disagreeing records.";
  map.row_label = "n";
  map.column_label = "N";
  map.value_label = "time / best baseline's time";
  for (const CellRatio& ratio : input.ratios) {
    if (!std::isnan(ratio.ratio.ratio)) map.cells.push_back(ratio_cell(ratio));
  }
  if (map.cells.empty()) return std::nullopt;
  Section section{"ratios", "Ratio to the best baseline", {}};
  section.blocks.emplace_back(map);
  add_table3(input, section);
  return section;
}

}  // namespace raygauge::report
