// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"
#include "results/text/language.h"
#include "scene/page/scene_answers.h"

namespace raygauge {
namespace {

constexpr std::size_t kMostCurves = 6;  // of a panel; farther pairs are not drawn
constexpr double kPanelHeight = 1.9;    // inches
constexpr std::array kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000"};
// Where curves lie on each other, the one below is seen through the dashes of the one above.
constexpr std::array kDashes = {"1", "'-'", "'.'", "'-.'", "'--'", "'-..'"};

/// An answer at an instant: distance where it was asked for, or minus the depth, otherwise growth.
struct Sample {
  std::int64_t instant = 0;
  double time = 0, value = 0, lower = 0, upper = 0;
};

using Pair = std::pair<std::int32_t, std::int32_t>;
using Curve = std::pair<Pair, std::vector<Sample>>;

struct Panel {
  std::string title, quantity;
  std::vector<Curve> curves;  ///< the nearest first
};

Sample sample_of(const SceneRecord& r) {
  if (r.distance == r.distance)
    return {r.instant, r.time, r.signed_distance(), r.signed_lower(), r.signed_upper()};
  return {r.instant, r.time, r.growth, r.growth_lower, r.growth_upper};
}

double least(const Curve& curve) {
  const auto smaller = [](const Sample& x, const Sample& y) { return x.value < y.value; };
  return std::min_element(curve.second.begin(), curve.second.end(), smaller)->value;
}

std::string body_name(const SceneFile& file, std::int32_t body) {
  return file.bodies[static_cast<std::size_t>(body)].name;
}

std::vector<Panel> panels_of(const SceneFile& file) {
  std::vector<Panel> panels;
  const std::vector<std::string> names = distinct_query_names(file);
  for (std::size_t q = 0; q < file.queries.size(); ++q) {
    std::map<Pair, std::vector<Sample>> found;
    Panel panel{names[q], "growth distance", {}};
    bool overlap = false;
    for (const SceneRow& row : file.records) {
      const SceneRecord& r = row.record;
      if (static_cast<std::size_t>(r.query) != q || !r.at_instant()) continue;
      const Sample sample = sample_of(r);
      if (!std::isfinite(sample.value)) continue;
      overlap |= sample.value < 0;
      if (r.distance == r.distance) {
        panel.quantity = overlap ? "signed distance" : "distance";
        if (!length_unit(file, r.query).empty()) panel.quantity += " / m";
      }
      found[{r.body_a, r.body_b}].push_back(sample);
    }
    if (found.empty()) continue;
    panel.curves.assign(found.begin(), found.end());
    std::stable_sort(panel.curves.begin(), panel.curves.end(),
                     [](const Curve& x, const Curve& y) { return least(x) < least(y); });
    if (panel.curves.size() > kMostCurves) panel.curves.resize(kMostCurves);
    panels.push_back(std::move(panel));
  }
  return panels;
}

/// "time value lower upper" a line; an empty line where an instant between two has no answer.
std::string data_block(const std::string& name, const std::vector<Sample>& samples) {
  std::string text = name + " << EOD\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (i > 0 && s.instant != samples[i - 1].instant + 1) text += "\n";
    for (const double number : {s.time, s.value, s.lower, s.upper}) text += rounded_text(number, 7) + " ";
    text += "\n";
  }
  return text + "EOD\n";
}

std::string vertical_line(double time, const char* color) {
  const std::string t = rounded_text(time, 7);
  return "set arrow from first " + t + ",graph 0 to first " + t + ",graph 1 nohead dt 2 lc rgb '" + color +
         "'\n";
}

/// Vertical lines at proven contacts (red) and, of each query, at the least clearance of all pairs (grey).
std::string event_lines(const SceneFile& file) {
  std::string text;
  std::map<std::int32_t, const SceneRecord*> least;
  for (const SceneRow& row : file.records) {
    const SceneRecord& r = row.record;
    if (r.kind == SceneEffects::time_of_impact && r.status == SceneStatus::contact)
      text += vertical_line(r.time_upper, "#C00000");
    if (r.kind != SceneEffects::clearance || !std::isfinite(r.time)) continue;
    const SceneRecord*& known = least[r.query];
    if (known == nullptr || r.upper < known->upper) known = &r;
  }
  for (const auto& [query, r] : least) {
    const bool touches = r->status == SceneStatus::intersecting;
    text += vertical_line(r->time, touches ? "#C00000" : "#909090");
  }
  return text;
}

/// gnuplot's range of times, that of all answers.
std::string time_range(const SceneFile& file) {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (const SceneRow& row : file.records) {
    if (!std::isfinite(row.record.time)) continue;
    from = std::min(from, row.record.time);
    to = std::max(to, row.record.time);
  }
  return "set xrange [" + rounded_text(from, 7) + ":" + rounded_text(to, 7) + "]\n";
}

std::string plot_of(const SceneFile& file, const Panel& panel, const std::string& prefix) {
  std::string text = "plot ";
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const std::string block = prefix + std::to_string(c);
    const std::string look = std::string(" lc rgb '") + kColors[c] + "'";
    const auto [a, b] = panel.curves[c].first;
    text += (c > 0 ? ", \\\n  " : "") + block + " using 1:3:4 with filledcurves fs transparent solid 0.25" +
            look + " notitle, \\\n  " + block + " using 1:2 with linespoints pt 7 ps 0.25 lw 1.3 dt " +
            kDashes[c] + look + " title " +
            language::gnuplot(body_name(file, a) + " – " + body_name(file, b));
  }
  return text + "\n";
}

/// Where the axis of a panel begins: at 0, or below it where bodies overlap.
std::string from_zero(const Panel& panel) {
  const bool below = std::any_of(panel.curves.begin(), panel.curves.end(),
                                 [](const Curve& curve) { return least(curve) < 0; });
  return below ? "*" : "0";
}

Drawing draw_over_time(const SceneFile& file, const std::vector<Panel>& panels, FigureSize size) {
  Drawing drawing;
  drawing.width = width_of(size);
  drawing.height = kPanelHeight * static_cast<double>(panels.size()) + 0.3;
  std::string plots;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::string prefix = "$panel" + std::to_string(p) + "curve";
    for (std::size_t c = 0; c < panels[p].curves.size(); ++c)
      drawing.script += data_block(prefix + std::to_string(c), panels[p].curves[c].second);
    plots += "set yrange [" + from_zero(panels[p]) + ":*]\nset title " + language::gnuplot(panels[p].title) +
             " offset 0,-0.7\nset ylabel " + language::gnuplot(panels[p].quantity) + "\n" +
             (p + 1 == panels.size() ? "set xlabel 'time / s' offset 0,0.5\n" : "") +
             plot_of(file, panels[p], prefix);
  }
  drawing.script +=
      "set encoding utf8\nset border 3\nset tics nomirror out scale 0.5\nset key outside right top\n"
      "set lmargin screen 0.09\nset rmargin screen 0.74\nset offsets 0,0,graph 0.05,0\n" +
      time_range(file) + event_lines(file) + "set multiplot layout " + std::to_string(panels.size()) +
      ",1\n" + plots + "unset multiplot\n";
  return drawing;
}

/// One instant: a mark with its certified interval for each query and pair.
Drawing draw_one_instant(const SceneFile& file, const std::vector<Panel>& panels, FigureSize size) {
  Drawing drawing;
  std::string tics;
  std::size_t count = 0;
  drawing.script = "$answers << EOD\n";
  for (const Panel& panel : panels) {
    for (const Curve& curve : panel.curves) {
      const Sample& s = curve.second.front();
      drawing.script += std::to_string(count) + " " + rounded_text(s.value, 7) + " " +
                        rounded_text(s.lower, 7) + " " + rounded_text(s.upper, 7) + "\n";
      const std::string pair =
          body_name(file, curve.first.first) + " – " + body_name(file, curve.first.second);
      tics += (tics.empty() ? "" : ", ") +
              language::gnuplot(panel.curves.size() > 1 ? panel.title + ": " + pair : panel.title) + " " +
              std::to_string(count++);
    }
  }
  drawing.width = width_of(size);
  drawing.height = 0.9 + 0.25 * static_cast<double>(count);
  drawing.script +=
      "EOD\nset encoding utf8\nset border 3\nset tics nomirror out scale 0.5\nunset key\nset ytics (" + tics +
      ")\nset yrange [" + std::to_string(count) + "-0.5:-0.5]\nset xlabel " +
      language::gnuplot(panels.front().quantity) + " offset 0,0.5\nset xrange [" + from_zero(panels.front()) +
      ":*]\n" +
      "plot $answers using 3:1:($4-$3):(0) with vectors nohead lw 5 lc rgb '#9CC3E0', "
      "$answers using 2:1 with points pt 7 ps 0.6 lc rgb '#0072B2'\n";
  return drawing;
}

}  // namespace

Drawing draw_scene(const SceneFile& file, FigureSize size) {
  const std::vector<Panel> panels = panels_of(file);
  if (panels.empty())
    throw FigureNeedsError("the picture of a scene needs distances or growth at instants: scene '" +
                           file.name + "' asks for neither");
  bool moves = false;
  for (const Panel& panel : panels)
    for (const Curve& curve : panel.curves) moves = moves || curve.second.size() > 1;
  return moves ? draw_over_time(file, panels, size) : draw_one_instant(file, panels, size);
}

}  // namespace raygauge
