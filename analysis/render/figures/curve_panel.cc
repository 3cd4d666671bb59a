// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/curve_panel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"
#include "results/text/language.h"

namespace raygauge {
namespace {

constexpr double kNoError = 1e-17;
constexpr double kInfiniteError = 1e4;

std::string curve_block_name(std::size_t panel, std::size_t curve) {
  return "$panel" + std::to_string(panel) + "curve" + std::to_string(curve);
}

std::string curve_block(const std::string& name, const PanelCurve& curve) {
  std::string text = name + " << EOD\n";
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const auto& [x, y] = curve.points[i];
    const auto& [low, high] = curve.bars.empty() ? std::pair(y, y) : curve.bars[i];
    for (const double value : {x, y, low, high}) text += rounded_text(value, 6) + " ";
    text += "\n";
  }
  text += "EOD\n";
  if (curve.flaws.empty()) return text;
  text += name + "flaws << EOD\n";
  for (const auto& [x, y] : curve.flaws) text += rounded_text(x, 6) + " " + rounded_text(y, 6) + "\n";
  return text + "EOD\n";
}

/// The curves, competitors below those of raygauge.
std::string plot_of(const CurvePanel& panel, std::size_t index, const MethodList& methods) {
  std::string text = "plot " + (panel.background.empty() ? "NaN notitle" : panel.background);
  for (const bool competitors : {true, false}) {
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      const std::string& method = panel.curves[c].method;
      if (methods.is_competitor(method) != competitors || panel.curves[c].points.empty()) continue;
      const std::string block = ", \\\n  " + curve_block_name(index, c);
      if (!panel.curves[c].bars.empty()) {
        text += block + " using 1:3:(0):($4-$3) with vectors nohead lw 0.7 lc rgb '" +
                figure_style::line_color(method, methods) + "'";
      }
      text += block + " using 1:2 with linespoints " + figure_style::line_style(method, methods);
      if (!panel.curves[c].flaws.empty())
        text += block + "flaws using 1:2 with points " + figure_style::kFlawStyle;
    }
  }
  return text + "\n";
}

/// Smaller letters where the title would run into the panel beside it.
std::string title_font(const std::string& title, const PanelGrid& grid) {
  constexpr double kPointsPerInch = 72;
  constexpr double kEms = 0.64;  // width of a letter, and some air
  constexpr double kUsual = 8;
  const double width = grid.width / static_cast<double>(grid.columns);
  const double fitting = kPointsPerInch * width / (kEms * static_cast<double>(title.size()));
  return fitting >= kUsual ? "" : " font '," + rounded_text(fitting, 2) + "'";
}

Drawing page_of_panels(const PanelGrid& grid, const std::vector<CurvePanel>& panels,
                       const MethodList& methods, const std::string& x, const std::string& y) {
  Drawing drawing;
  drawing.width = grid.width;
  drawing.height = grid.height();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t c = 0; c < panels[p].curves.size(); ++c) {
      if (panels[p].curves[c].points.empty()) continue;
      drawing.script += curve_block(curve_block_name(p, c), panels[p].curves[c]);
    }
  }
  drawing.script += "set encoding utf8\nset xrange [1:10]\nset yrange [1:10]\nset multiplot\n" +
                    grid.axis_labels(x, y) + grid.legend_plot(methods);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    drawing.script += grid.margins(p) + panels[p].settings + "set title " +
                      language::gnuplot(panels[p].title) + title_font(panels[p].title, grid) +
                      " offset 0,-0.7\n" + plot_of(panels[p], p, methods);
  }
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace

bool has_flaws(const std::vector<CurvePanel>& panels) {
  return std::any_of(panels.begin(), panels.end(), [](const CurvePanel& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const PanelCurve& curve) { return !curve.flaws.empty(); });
  });
}

Drawing draw_curve_panels(const PanelGrid& grid, const std::vector<CurvePanel>& panels,
                          const MethodList& methods, const std::string& x, const std::string& y) {
  const std::size_t most = grid.columns * grid.rows_a_page();
  std::vector<Drawing> pages;
  for (std::size_t first = 0; first < panels.size(); first += most) {
    const std::size_t last = std::min(first + most, panels.size());
    PanelGrid page = grid;
    page.rows = (last - first + grid.columns - 1) / grid.columns;
    pages.push_back(page_of_panels(page,
                                   {panels.begin() + static_cast<std::ptrdiff_t>(first),
                                    panels.begin() + static_cast<std::ptrdiff_t>(last)},
                                   methods, x, y));
  }
  Drawing drawing = std::move(pages.front());
  drawing.next_pages.assign(std::make_move_iterator(pages.begin() + 1), std::make_move_iterator(pages.end()));
  return drawing;
}

std::pair<double, double> range_of(const std::vector<PanelCurve>& curves, bool of_y, double factor) {
  double low = kInfinity;
  double high = -low;
  for (const PanelCurve& curve : curves) {
    for (const auto& [x, y] : curve.points) {
      low = std::min(low, of_y ? y : x);
      high = std::max(high, of_y ? y : x);
    }
    if (!of_y) continue;
    for (const auto& [from, to] : curve.bars) {
      low = std::min(low, from);
      high = std::max(high, to);
    }
  }
  if (low > high) return {1, 10};
  return {low / factor, high * factor};
}

double drawn_error(double error) {
  constexpr double kLargestError = 1e2;
  return error > kLargestError ? kInfiniteError : std::max(error, kNoError);
}

std::string error_axis(bool labelled) {
  const auto tick = [&](const std::string& label, double place) {
    return (labelled ? "'" + label + "' " : "'' ") + rounded_text(place, 1);
  };
  std::string ticks = tick("0", kNoError) + ", " + tick("∞", kInfiniteError);
  for (const int exponent : {-15, -12, -9, -6, -3, 0})
    ticks += ", " + tick("10^{" + std::to_string(exponent) + "}", std::pow(10, exponent));
  return "set logscale y\nset yrange [1e-18:1e5]\nset ytics nomirror (" + ticks + ")\n";
}

std::string range_setting(const char* name, double from, double to) {
  return std::string("set ") + name + "range [" + rounded_text(from, 6) + ":" + rounded_text(to, 6) + "]\n";
}

}  // namespace raygauge
