// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/ratio_heatmap.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/data/pool.h"
#include "analysis/render/figures/cell_map.h"
#include "analysis/render/figures/problem_pages.h"
#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"
#include "results/text/language.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

using figure_style::screen;

constexpr const char* kHeatmapName = "ratio_heatmap";

/// Limits of the colours, in per cent.
struct ColorRange {
  double low = kInfinity;
  double high = 0;
};

bool has_percent(const CellRatio& ratio) { return std::isfinite(ratio.ratio.ratio) && ratio.ratio.ratio > 0; }

ColorRange color_range(const std::vector<CellRatio>& ratios) {
  ColorRange range;
  for (const CellRatio& ratio : ratios) {
    if (!has_percent(ratio)) continue;
    range.low = std::min(range.low, 100 * ratio.ratio.ratio);
    range.high = std::max(range.high, 100 * ratio.ratio.ratio);
  }
  if (!(range.low <= range.high))
    throw FigureNeedsError(std::string("figure ") + kHeatmapName +
                           " needs cells where a method and a baseline are solved");
  constexpr double kMargin = 1.05;
  return {range.low / kMargin, range.high * kMargin};
}

/// Inches.
constexpr double kScale = 0.58;    // right of the cells, for the scale of colours
constexpr double kHeading = 0.42;  // above the first panel, its title included
constexpr double kPanelTitle = 0.24;
constexpr double kRatioCharacters = 4.6;  // "0.12" and a little air

double heatmap_height(const CellMap& map, std::size_t panels) {
  const auto count = static_cast<double>(panels);
  return kHeading + count * map.height() + (count - 1) * kPanelTitle + CellMap::kBottom;
}

std::string percent_text(double percent) { return padded_significant(percent, 2); }

/// Dark colours take white numbers. Colours run from dark (low) to light (high).
bool is_dark(double percent, const ColorRange& range) {
  constexpr double kTurn = 0.55;
  return std::log(percent / range.low) < kTurn * std::log(range.high / range.low);
}

/// column row percent text color
std::string ratio_block(std::size_t index, const std::vector<CellRatio>& ratios, const std::string& method,
                        const CellMap& map, const ColorRange& range) {
  std::string text = "$ratios" + std::to_string(index) + " << EOD\n";
  for (const CellRatio& ratio : ratios) {
    if (ratio.times.method != method || !has_percent(ratio)) continue;
    const double percent = 100 * ratio.ratio.ratio;
    text += map.place(ratio.times.cell) + " " + rounded_text(percent, 6) + " " + percent_text(percent) + " " +
            (is_dark(percent, range) ? "0xFFFFFF" : "0x000000") + "\n";
  }
  return text + "EOD\n";
}

/// The scale of the colours, right of all panels. Viridis: its lightness rises evenly, so it reads in grey
/// and for colour-blind readers.
std::string color_settings(const CellMap& map, const ColorRange& range, double height) {
  constexpr double kLabel = 0.15;  // inches from one label to the next
  const double length = height - CellMap::kBottom - kHeading;
  const auto labels = static_cast<std::size_t>(std::clamp(length / kLabel, 2.0, 9.0));
  return "set palette defined (0 '#440154', 1 '#46327E', 2 '#365C8D', 3 '#277F8E', 4 '#1FA187', 5 "
         "'#4AC16D', 6 '#A0DA39', 7 '#FDE725')\nset logscale cb\nset cbrange [" +
         rounded_text(range.low, 6) + ":" + rounded_text(range.high, 6) + "]\nset cbtics " +
         figure_style::one_two_five_ticks(range.low, range.high, labels) +
         " scale 0.5\nset format cb '%g'\nset colorbox user origin screen " +
         screen((map.right_end() + 0.1) / map.width()) + ", screen " + screen(CellMap::kBottom / height) +
         " size screen " + screen(0.12 / map.width()) + ", screen " + screen(length / height) + " noborder\n";
}

std::string ratio_panel(const CellMap& map, double height, std::size_t index, std::size_t panels,
                        const std::string& method) {
  const double top = height - kHeading - static_cast<double>(index) * (map.height() + kPanelTitle);
  const std::string block = "$ratios" + std::to_string(index);
  return map.margins(top, height) + "set title " + language::gnuplot(method) + " offset 0,-0.8\n" +
         (index + 1 == panels ? map.bottom_axis(kRatioCharacters) : "unset xlabel\nunset xtics\n") + "plot " +
         block + " using " + kCellBox + ":3 with boxxyerror lc palette, \\\n  " + block +
         " using 1:2:4:5 with labels " + map.font(kRatioCharacters) + " tc rgb variable\nunset colorbox\n";
}

/// What the numbers and colours are, above the panels.
std::string ratio_heading(const std::vector<std::string>& baselines, const std::string& problem, bool pooled,
                          double height) {
  const std::string text = baselines.size() > 1 ? "time, % of the best of " : "time, % of ";
  const std::string where = problem.empty() ? "" : problem + ": ";
  const std::string means = pooled ? ", geometric means" : "";
  return "set label 9 " + language::gnuplot(where + text + joined(baselines, ", ") + means) +
         " at screen 0.5, screen " + screen(1 - 0.1 / height) + " center\n";
}

}  // namespace

namespace {

/// The page of one problem; `records` are all there are, for the times of baselines.
Drawing heatmap_of(const Problem& problem, const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record>& kept = problem.records;
  const std::vector<std::string> baselines =
      options.baselines.empty() ? default_baselines(records) : options.baselines;
  if (baselines.empty())
    throw FigureNeedsError(std::string("figure ") + kHeatmapName +
                           " needs a method that is a baseline; or name one with --baseline");
  const std::vector<CellRatio> ratios =
      cell_ratios(kept, Pool(records)(baseline_records(records, options.filter, baselines)), baselines);
  const ColorRange range = color_range(ratios);
  std::vector<CellKey> cells;
  for (const CellRatio& ratio : ratios) cells.push_back(ratio.times.cell);
  require_two_cells(kHeatmapName, cells);
  std::vector<std::string> methods;
  for (const std::string& method : methods_of(kept)) {
    const bool drawn = std::any_of(ratios.begin(), ratios.end(),
                                   [&](const CellRatio& ratio) { return ratio.times.method == method; });
    if (drawn) methods.push_back(method);
  }
  const CellMap map(cells, width_of(options.size), kScale);
  Drawing drawing;
  drawing.width = map.width();
  drawing.height = heatmap_height(map, methods.size());
  for (std::size_t m = 0; m < methods.size(); ++m)
    drawing.script += ratio_block(m, ratios, methods[m], map, range);
  drawing.script += "set multiplot\nunset key\nset style fill solid noborder\n" + map.settings() +
                    color_settings(map, range, drawing.height) +
                    ratio_heading(baselines, problem.name, is_pool(cells.front()), drawing.height);
  for (std::size_t m = 0; m < methods.size(); ++m)
    drawing.script += ratio_panel(map, drawing.height, m, methods.size(), methods[m]) + "unset label 9\n";
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace

Drawing ratio_heatmap(const std::vector<Record>& records, const FigureOptions& options) {
  return page_for_each_problem(kHeatmapName, records, options.filter,
                               [&](const Problem& problem) { return heatmap_of(problem, records, options); });
}

}  // namespace raygauge
