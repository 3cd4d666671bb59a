// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/cell_map.h"

#include <algorithm>
#include <set>
#include <utility>

#include "analysis/render/figures/figure.h"
#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

using figure_style::screen;

constexpr double kCellLeft = 0.45;    // inches, for the labels of n
constexpr double kCellHeight = 0.19;  // inches

std::string rank_in(const std::vector<int>& values, int value) {
  return std::to_string(std::lower_bound(values.begin(), values.end(), value) - values.begin());
}

/// Each value at its rank: "('3' 0, '5' 1)".
std::string rank_ticks(const std::vector<int>& values) {
  std::string text;
  for (const int value : values)
    text += (text.empty() ? "('" : ", '") + std::to_string(value) + "' " + rank_in(values, value);
  return text + ")";
}

}  // namespace

void require_two_cells(const std::string& figure, const std::vector<CellKey>& cells) {
  std::set<std::pair<int, int>> places;
  for (const CellKey& cell : cells) places.emplace(cell.n, cell.N);
  if (places.size() < 2)
    throw FigureNeedsError("figure " + figure + " is a map over n and N, and there is one cell: " +
                           "raygauge table shows its numbers");
}

CellMap::CellMap(const std::vector<CellKey>& cells, double width, double right)
    : width_(width), right_(right) {
  std::set<int> n;
  std::set<int> N;
  for (const CellKey& cell : cells) {
    n.insert(cell.n);
    N.insert(cell.N);
  }
  n_.assign(n.begin(), n.end());
  N_.assign(N.begin(), N.end());
}

double CellMap::height() const { return kCellHeight * static_cast<double>(n_.size()); }

std::string CellMap::place(const CellKey& cell) const {
  return rank_in(N_, cell.N) + " " + rank_in(n_, cell.n);
}

std::string CellMap::settings() const {
  return "set border 0\nset ytics " + rank_ticks(n_) +
         " scale 0 offset 0.6,0\nset ylabel 'n' offset 1.5,0 rotate by 0\nset xrange [-0.5:" +
         std::to_string(N_.size()) + "-0.5]\nset yrange [" + std::to_string(n_.size()) +
         "-0.5:-0.5]\nset lmargin at screen " + screen(kCellLeft / width_) + "\nset rmargin at screen " +
         screen(right_end() / width_) + "\n";
}

std::string CellMap::margins(double top, double figure_height) const {
  return "set tmargin at screen " + screen(top / figure_height) + "\nset bmargin at screen " +
         screen((top - height()) / figure_height) + "\n";
}

std::string CellMap::bottom_axis(double characters) const {
  return "set xlabel 'N, points in each set' offset 0,0.8\nset xtics " + rank_ticks(N_) +
         " scale 0 offset 0,0.4 " + font(characters) + "\n";
}

std::string CellMap::font(double characters) const {
  constexpr double kPointsPerInch = 72;
  constexpr double kEms = 0.62;  // width of a digit
  constexpr double kLargest = 7;
  const double cell_width = (right_end() - kCellLeft) / static_cast<double>(N_.size());
  return "font '," + rounded_text(std::min(kLargest, kPointsPerInch * cell_width / (kEms * characters)), 3) +
         "'";
}

}  // namespace raygauge
