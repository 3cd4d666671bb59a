// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/figures/true_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "analysis/cell_ratio.h"
#include "analysis/figures/panel_grid.h"
#include "analysis/figures/style.h"
#include "analysis/number_text.h"
#include "analysis/truth.h"

namespace raygauge {
namespace {

constexpr const char* kName = "true_error";

/// A parameter that makes a family harder, and how it is drawn.
struct Hardness {
  const char* parameter;
  const char* label;
  double (*of)(double value);
};

constexpr std::array<Hardness, 5> kHardness = {{
    {"aspect", "aspect", [](double value) { return value; }},
    {"delta", "1/δ", [](double value) { return 1 / value; }},
    {"entry", "entry", [](double value) { return value; }},
    {"exponent", "scale", [](double value) { return std::exp2(value); }},
    {"offset", "offset", [](double value) { return value; }},
}};

/// Largest error by hardness.
using Curve = std::map<double, double>;

struct Panel {
  std::string title;
  std::map<std::string, Curve> curves;  ///< by method
  double x_low = std::numeric_limits<double>::infinity();
  double x_high = 0;
};

/// The value of NAME=VALUE among "a=1 name=2".
std::optional<double> parameter_of(const Record& record, const std::string& name) {
  const std::string text = " " + record.generator_parameters;
  const std::size_t found = text.find(" " + name + "=");
  if (found == std::string::npos) return std::nullopt;
  return std::strtod(text.c_str() + found + name.size() + 2, nullptr);
}

void add(Panel& panel, const Hardness& hardness, const Record& record, double value, double error) {
  panel.title = record.generator + ": " + hardness.label;
  const double x = hardness.of(value);
  panel.x_low = std::min(panel.x_low, x);
  panel.x_high = std::max(panel.x_high, x);
  double& worst = panel.curves[record.method].try_emplace(x, error).first->second;
  worst = std::max(worst, error);
}

/// The methods that are judged: `exact` is where the truth comes from.
std::vector<Record> judged(const std::vector<Record>& records) {
  std::vector<Record> kept;
  for (const Record& record : records) {
    if (record.method.rfind("exact", 0) != 0) kept.push_back(record);
  }
  return kept;
}

/// The families in order of their names.
std::vector<Panel> panels_of(const std::vector<Record>& records, const Truth& truth) {
  std::map<std::string, Panel> panels;
  for (const Record& record : records) {
    const double error = true_error(record, truth(record));
    if (std::isnan(error)) continue;
    for (const Hardness& hardness : kHardness) {
      const std::optional<double> value = parameter_of(record, hardness.parameter);
      if (value) add(panels[record.generator], hardness, record, *value, error);
    }
  }
  std::vector<Panel> result;
  for (auto& [family, panel] : panels) {
    if (panel.x_low < panel.x_high) result.push_back(std::move(panel));
  }
  if (result.empty())
    throw FigureNeedsError(std::string("figure ") + kName +
                           " needs answers of known truth at two or more values of a generator's parameter "
                           "aspect, delta, entry, exponent or offset");
  return result;
}

constexpr double kZero = 1e-17;  ///< where errors of nothing are drawn
constexpr double kLargest = 1e2;
constexpr double kInfinite = 1e4;  ///< where those beyond are

double drawn(double error) { return error > kLargest ? kInfinite : std::max(error, kZero); }

std::string block_name(std::size_t panel, std::size_t method) {
  return "$panel" + std::to_string(panel) + "curve" + std::to_string(method);
}

std::string data_block(const std::string& name, const Curve& curve) {
  std::string text = name + " << EOD\n";
  for (const auto& [x, error] : curve) text += significant(x, 6) + " " + significant(drawn(error), 6) + "\n";
  return text + "EOD\n";
}

/// About four powers of ten, as gnuplot's list.
std::string decade_ticks(double low, double high) {
  constexpr double kMost = 4;
  const int first = static_cast<int>(std::ceil(std::log10(low)));
  const int last = static_cast<int>(std::floor(std::log10(high)));
  const int step = std::max(1, static_cast<int>(std::ceil((last - first) / kMost)));
  std::string ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    if (exponent % step != 0) continue;
    const std::string power = std::to_string(exponent);
    ticks += (ticks.empty() ? "'10^{" : ", '10^{") + power + "}' 1e" + power;
  }
  return "(" + ticks + ")";
}

std::string error_ticks(bool labelled) {
  std::string ticks = labelled ? "'0' 1e-17, '∞' 1e4" : "'' 1e-17, '' 1e4";
  for (const int exponent : {-15, -12, -9, -6, -3, 0}) {
    const std::string power = std::to_string(exponent);
    ticks += ", '" + (labelled ? "10^{" + power + "}" : std::string()) + "' 1e" + power;
  }
  return "(" + ticks + ")";
}

std::string panel_settings(const PanelGrid& grid, std::size_t index, const Panel& panel) {
  const double margin = std::pow(panel.x_high / panel.x_low, 0.05);
  const double low = panel.x_low / margin;
  const double high = panel.x_high * margin;
  return grid.margins(index) + "set xrange [" + significant(low, 6) + ":" + significant(high, 6) +
         "]\nset xtics nomirror " + decade_ticks(low, high) + "\nset ytics nomirror " +
         error_ticks(grid.is_left(index)) + "\nset title " + figure_style::quoted(panel.title) +
         " offset 0,-0.7\n";
}

/// The curves, competitors below those of raygauge.
std::string plot_command(const Panel& panel, std::size_t index, const std::vector<std::string>& methods,
                         double tolerance) {
  std::string text = "plot " + significant(10 * tolerance, 6) + " with lines lc rgb '#8C8C8C' lw 0.8 dt 1";
  for (const bool competitors : {true, false}) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (is_competitor(methods[m]) != competitors || panel.curves.count(methods[m]) == 0) continue;
      text += ", \\\n  " + block_name(index, m) + " using 1:2 with linespoints " +
              figure_style::line_style(methods[m], methods);
    }
  }
  return text + "\n";
}

}  // namespace

Drawing true_error_figure(const std::vector<Record>& records, const FigureOptions& options) {
  const std::vector<Record> kept =
      judged(figure_style::comparable_records(kName, records, options.filter, {"tolerance"}));
  const std::vector<Panel> panels = panels_of(kept, Truth(records));
  const std::vector<std::string> methods = methods_of(kept);
  const bool single = options.size == FigureSize::single;
  PanelGrid grid = panel_grid(panels.size(), methods.size(), options.size, single ? 2 : 3);
  grid.x_labels = 0.2;

  Drawing drawing;
  drawing.width = grid.width;
  drawing.height = grid.height();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto curve = panels[p].curves.find(methods[m]);
      if (curve != panels[p].curves.end()) drawing.script += data_block(block_name(p, m), curve->second);
    }
  }
  drawing.script += "set encoding utf8\nset multiplot\nset logscale xy\nset yrange [1e-18:1e5]\n" +
                    grid.axis_labels("conditioning or scale", "largest true error") +
                    grid.legend_plot(methods);
  for (std::size_t p = 0; p < panels.size(); ++p)
    drawing.script +=
        panel_settings(grid, p, panels[p]) + plot_command(panels[p], p, methods, kept.front().tolerance);
  drawing.script += "unset multiplot\n";
  return drawing;
}

}  // namespace raygauge
