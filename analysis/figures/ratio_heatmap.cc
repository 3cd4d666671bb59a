// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/ratio_heatmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "analysis/cell_ratio.h"
#include "analysis/figures/style.h"
#include "analysis/number_text.h"

namespace raygauge {
namespace {

constexpr const char* kName = "ratio_heatmap";

/// Values of n and N in order: a cell's place is its index.
struct Grid {
  std::vector<int> n;
  std::vector<int> N;
};

std::size_t index_in(const std::vector<int>& values, int value) {
  return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
}

Grid grid_of(const std::vector<CellRatio>& ratios) {
  std::set<int> n;
  std::set<int> N;
  for (const CellRatio& ratio : ratios) {
    n.insert(ratio.times.cell.n);
    N.insert(ratio.times.cell.N);
  }
  return {{n.begin(), n.end()}, {N.begin(), N.end()}};
}

/// Limits of the colours, in per cent.
struct ColorRange {
  double low = std::numeric_limits<double>::infinity();
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
    throw FigureNeedsError(std::string("figure ") + kName +
                           " needs cells where a method and a baseline are solved");
  constexpr double kMargin = 1.05;
  return {range.low / kMargin, range.high * kMargin};
}

/// Inches.
struct Layout {
  double width = 0;
  double cell_height = 0.19;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t panels = 0;
  static constexpr double kLeft = 0.45;
  static constexpr double kRight = 0.58;
  static constexpr double kTop = 0.42;
  static constexpr double kBottom = 0.4;
  static constexpr double kTitle = 0.24;

  double panel_width() const { return width - kLeft - kRight; }
  double panel_height() const { return cell_height * static_cast<double>(rows); }
  double height() const {
    const auto count = static_cast<double>(panels);
    return kTop + count * panel_height() + (count - 1) * kTitle + kBottom;
  }
  /// Points that a cell's number may be wide: four characters of 0.62 em each, at most 7 points high.
  double font_size() const {
    constexpr double kPointsPerInch = 72;
    constexpr double kEms = 4 * 0.62 + 0.4;
    constexpr double kLargest = 7;
    return std::min(kLargest, kPointsPerInch * panel_width() / static_cast<double>(columns) / kEms);
  }
};

std::string percent_text(double percent) { return padded_significant(percent, 2); }

/// Dark colours take white numbers. Colours run from dark (low) to light (high).
bool is_dark(double percent, const ColorRange& range) {
  constexpr double kTurn = 0.55;
  return std::log(percent / range.low) < kTurn * std::log(range.high / range.low);
}

/// x y percent text color
std::string data_block(const std::string& name, const std::vector<CellRatio>& ratios,
                       const std::string& method, const Grid& grid, const ColorRange& range) {
  std::string text = "$" + name + " << EOD\n";
  for (const CellRatio& ratio : ratios) {
    if (ratio.times.method != method || !has_percent(ratio)) continue;
    const double percent = 100 * ratio.ratio.ratio;
    text += std::to_string(index_in(grid.N, ratio.times.cell.N)) + " " +
            std::to_string(index_in(grid.n, ratio.times.cell.n)) + " " + significant(percent, 6) + " " +
            percent_text(percent) + " " + (is_dark(percent, range) ? "0xFFFFFF" : "0x000000") + "\n";
  }
  return text + "EOD\n";
}

std::string tick_list(const std::vector<int>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += i == 0 ? "('" : ", '";
    text += std::to_string(values[i]) + "' " + std::to_string(i);
  }
  return text + ")";
}

std::string fraction(double value) { return significant(value, 6); }

std::string common_settings(const Grid& grid, const ColorRange& range, const Layout& layout) {
  const double height = layout.height();
  const double right = layout.width - Layout::kRight;
  // Viridis: its lightness rises evenly, so it reads in grey and for colour-blind readers.
  return "set multiplot\n"
         "set palette defined (0 '#440154', 1 '#46327E', 2 '#365C8D', 3 '#277F8E', 4 '#1FA187', 5 '#4AC16D', "
         "6 '#A0DA39', 7 '#FDE725')\n"
         "set logscale cb\n"
         "set cbrange [" +
         significant(range.low, 6) + ":" + significant(range.high, 6) +
         "]\n"
         "set cbtics " +
         figure_style::one_two_five_ticks(range.low, range.high) +
         " scale 0.5\n"
         "set format cb '%g'\n"
         "unset key\nset border 0\nset style fill solid noborder\n"
         "set ytics " +
         tick_list(grid.n) +
         " scale 0 offset 0.6,0\n"
         "set xrange [-0.5:" +
         std::to_string(grid.N.size()) +
         "-0.5]\n"
         "set yrange [" +
         std::to_string(grid.n.size()) +
         "-0.5:-0.5]\n"
         "set lmargin at screen " +
         fraction(Layout::kLeft / layout.width) +
         "\n"
         "set rmargin at screen " +
         fraction(right / layout.width) +
         "\n"
         "set colorbox user origin screen " +
         fraction((right + 0.1) / layout.width) + ", screen " + fraction(Layout::kBottom / height) +
         " size screen " + fraction(0.12 / layout.width) + ", screen " +
         fraction((height - Layout::kBottom - Layout::kTop) / height) + " noborder\n";
}

std::string panel(const Layout& layout, const Grid& grid, std::size_t index, const std::string& method) {
  const double height = layout.height();
  const double top =
      height - Layout::kTop - static_cast<double>(index) * (layout.panel_height() + Layout::kTitle);
  const bool last = index + 1 == layout.panels;
  const std::string block = "$ratios" + std::to_string(index);
  return "set tmargin at screen " + fraction(top / height) + "\nset bmargin at screen " +
         fraction((top - layout.panel_height()) / height) + "\nset title " + figure_style::quoted(method) +
         " offset 0,-0.8\nset ylabel 'n' offset 1.5,0 rotate by 0\n" +
         (last ? "set xlabel 'N, points in each set' offset 0,0.8\nset xtics " + tick_list(grid.N) +
                     " scale 0 offset 0,0.4 font '," + significant(layout.font_size(), 3) + "'\n"
               : "unset xlabel\nunset xtics\n") +
         "plot " + block +
         " using 1:2:($1-0.48):($1+0.48):($2-0.47):($2+0.47):3 with boxxyerror lc palette, \\\n  " + block +
         " using 1:2:4:5 with labels font '," + significant(layout.font_size(), 3) + "' tc rgb variable\n" +
         "unset colorbox\n";
}

/// What the numbers and colours are, above the panels.
std::string heading(const std::vector<std::string>& baselines, const Layout& layout) {
  std::string text = baselines.size() > 1 ? "time, % of the best of " : "time, % of ";
  for (const std::string& baseline : baselines)
    text += (&baseline == &baselines.front() ? "" : ", ") + baseline;
  return "set label 9 " + figure_style::quoted(text) + " at screen 0.5, screen " +
         fraction(1 - 0.1 / layout.height()) + " center\n";
}

}  // namespace

Drawing ratio_heatmap(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept = figure_style::comparable_records(kName, records, options.filter);
  const std::vector<std::string> baselines =
      options.baselines.empty() ? default_baselines(records) : options.baselines;
  if (baselines.empty())
    throw FigureNeedsError(std::string("figure ") + kName +
                           " needs a baseline, a method that begins with glpk; or name one with --baseline");
  const std::vector<CellRatio> ratios =
      cell_ratios(kept, baseline_records(records, options.filter, baselines), baselines);
  const ColorRange range = color_range(ratios);
  const Grid grid = grid_of(ratios);
  std::vector<std::string> methods;
  for (const std::string& method : methods_of(kept)) {
    const bool drawn = std::any_of(ratios.begin(), ratios.end(),
                                   [&](const CellRatio& ratio) { return ratio.times.method == method; });
    if (drawn) methods.push_back(method);
  }
  Layout layout;
  layout.width = width_of(options.size);
  layout.rows = grid.n.size();
  layout.columns = grid.N.size();
  layout.panels = methods.size();

  Drawing drawing;
  drawing.width = layout.width;
  drawing.height = layout.height();
  for (std::size_t m = 0; m < methods.size(); ++m)
    drawing.script += data_block("ratios" + std::to_string(m), ratios, methods[m], grid, range);
  drawing.script += common_settings(grid, range, layout) + heading(baselines, layout);
  for (std::size_t m = 0; m < methods.size(); ++m)
    drawing.script += panel(layout, grid, m, methods[m]) + "unset label 9\n";
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
