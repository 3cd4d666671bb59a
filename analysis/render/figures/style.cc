// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/pool.h"
#include "analysis/render/figures/figure.h"
#include "analysis/render/method_look.h"
#include "engine/numerics/number_text.h"

namespace raygauge::figure_style {
namespace {

/// gnuplot's numbers of the filled markers; the open one of each is one below.
int point_type(const MethodLook& look) {
  constexpr std::array<int, 5> kFilled = {7, 5, 9, 13, 11};
  return kFilled.at(static_cast<std::size_t>(look.marker)) - (look.filled ? 0 : 1);
}

std::string dash_type(Dash dash) {
  constexpr std::array<const char*, 4> kTypes = {"1", "'-'", "'.'", "'-.'"};
  return kTypes.at(static_cast<std::size_t>(dash));
}

constexpr const char* kPaperColor = "#8C8C8C";
constexpr int kPaperPoint = 2;

/// The numbers step · 10^k within [low, high], in order.
std::vector<double> round_numbers(double low, double high, const std::vector<int>& steps) {
  std::vector<double> numbers;
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10, exponent) <= high;
       ++exponent) {
    for (const int step : steps) {
      const double number = step * std::pow(10, exponent);
      if (number >= low && number <= high) numbers.push_back(number);
    }
  }
  return numbers;
}

/// Both ends with as few digits as leave them within [low, high]: gnuplot draws no tick beyond.
std::string ends_within(double low, double high) {
  constexpr int kMostDigits = 6;
  for (int digits = 2; digits < kMostDigits; ++digits) {
    const double unit = std::pow(10, std::floor(std::log10(low)) + 1 - digits);
    const double first = unit * std::ceil(low / unit);
    const double last = unit * std::floor(high / unit);
    if (first < last) return rounded_text(first, kMostDigits) + ", " + rounded_text(last, kMostDigits);
  }
  return rounded_text(low, kMostDigits);
}

}  // namespace

std::string line_style(const std::string& method, const MethodList& methods) {
  const MethodLook look = look_of_method(method, methods);
  const bool paper = method == kPaperCurve;
  return "lc rgb '" + line_color(method, methods) + "' dt " + (paper ? "1" : dash_type(look.dash)) +
         " lw 1 pt " + std::to_string(paper ? kPaperPoint : point_type(look)) + " ps 0.45";
}

std::string step_style(const std::string& method, const MethodList& methods) {
  return "lc rgb '" + line_color(method, methods) + "' dt " +
         dash_type(look_of_method(method, methods).dash) + " lw 1.4";
}

std::string line_color(const std::string& method, const MethodList& methods) {
  return method == kPaperCurve ? kPaperColor : look_of_method(method, methods).color;
}

std::string screen(double fraction) { return rounded_text(fraction, 6); }

std::string one_two_five_ticks(double low, double high, std::size_t most) {
  std::vector<double> ticks = round_numbers(low, high, {1, 2, 5});
  if (ticks.size() > most) {
    ticks = round_numbers(low, high, {1});
    // Every second, third, … power of ten.
    const std::size_t stride = std::max<std::size_t>(1, (ticks.size() + most - 1) / most);
    for (std::size_t i = 0; i * stride < ticks.size(); ++i) ticks[i] = ticks[i * stride];
    ticks.resize((ticks.size() + stride - 1) / stride);
  }
  if (ticks.size() < 2) return "(" + ends_within(low, high) + ")";
  std::string text;
  for (const double tick : ticks) text += (text.empty() ? "" : ", ") + rounded_text(tick, 2);
  return "(" + text + ")";
}

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

std::vector<Record> comparable_records(const std::string& figure, const std::vector<Record>& records,
                                       const Filter& filter) {
  std::vector<Record> kept = filtered(records, filter);
  if (kept.empty()) {
    throw FigureNeedsError("figure " + figure + ": " +
                           (records.empty() ? std::string("no records")
                                            : "no record passes the filter '" + filter.expression() + "'"));
  }
  return Pool(records)(std::move(kept));
}

}  // namespace raygauge::figure_style
