// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/overview/fastest_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "analysis/constants.h"
#include "analysis/render/report/blocks.h"
#include "analysis/statistics/statistics.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

/// What a row or a column of the picture may be.
struct Direction {
  std::string label;
  std::function<std::pair<double, std::string>(const CellKey&)> value;  ///< its place in the order, its name
  std::vector<std::pair<double, std::string>> values = {};

  std::size_t place_of(const CellKey& cell) const {
    return static_cast<std::size_t>(std::find(values.begin(), values.end(), value(cell)) - values.begin());
  }
};

std::pair<double, std::string> number_and_name(double value) { return {value, rounded_text(value, 4)}; }

/// The directions with their values, the one with the most values first.
std::vector<Direction> directions_of(const std::vector<CellTimes>& all) {
  std::set<std::string> problems;
  for (const CellTimes& times : all) problems.insert(problem_name(times.cell));
  constexpr std::size_t kMostProblems = 12;
  const bool families = problems.size() > kMostProblems;
  std::vector<Direction> directions = {
      {"N", [](const CellKey& cell) { return number_and_name(cell.N); }},
      {"n", [](const CellKey& cell) { return number_and_name(cell.n); }},
      {"tolerance", [](const CellKey& cell) { return number_and_name(cell.tolerance); }},
      {"problem", [families](const CellKey& cell) {
         return std::pair(0.0, families ? cell.generator : problem_name(cell));
       }}};
  for (Direction& direction : directions) {
    std::set<std::pair<double, std::string>> values;
    for (const CellTimes& times : all) values.insert(direction.value(times.cell));
    direction.values.assign(values.begin(), values.end());
  }
  std::stable_sort(directions.begin(), directions.end(),
                   [](const Direction& a, const Direction& b) { return a.values.size() > b.values.size(); });
  return directions;
}

/// The two directions that spread the cells over the most places, the one with more values first.
std::pair<Direction, Direction> most_spread(const std::vector<Direction>& directions,
                                            const std::vector<CellTimes>& all) {
  std::pair<Direction, Direction> best{directions[0], directions[1]};
  std::size_t most = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = i + 1; j < directions.size(); ++j) {
      std::set<std::pair<std::size_t, std::size_t>> places;
      for (const CellTimes& times : all)
        places.emplace(directions[i].place_of(times.cell), directions[j].place_of(times.cell));
      if (places.size() <= most) continue;
      most = places.size();
      best = {directions[i], directions[j]};
    }
  }
  return best;
}

/// One method in one place of the picture.
struct Standing {
  std::vector<double> ratios;  ///< of its median to the least one, in each cell that it solved
  std::size_t disagreeing = 0;

  double mean() const { return ratios.empty() ? kInfinity : geometric_mean(ratios); }
};

using Place = std::map<std::string, Standing>;  // by method
using Places = std::map<std::pair<std::size_t, std::size_t>, Place>;

Places places_of(const std::vector<CellTimes>& all, const Direction& rows, const Direction& columns) {
  std::map<CellKey, double> least;
  for (const CellTimes& times : all) {
    if (times.seconds.empty()) continue;
    double& known = least.try_emplace(times.cell, kInfinity).first->second;
    known = std::min(known, center_of(times).seconds);
  }
  Places places;
  for (const CellTimes& times : all) {
    Standing& standing = places[{rows.place_of(times.cell), columns.place_of(times.cell)}][times.method];
    standing.disagreeing += times.disagreeing;
    if (times.seconds.empty()) continue;
    const double seconds = center_of(times).seconds, best = least.at(times.cell);
    if (std::isfinite(seconds) && best > 0) standing.ratios.push_back(seconds / best);
  }
  return places;
}

/// The methods of a place by how many cells they solved, then by time.
std::vector<std::string> ranking(const Place& place) {
  std::vector<std::string> methods;
  for (const auto& [method, standing] : place)
    if (!standing.ratios.empty()) methods.push_back(method);
  std::stable_sort(methods.begin(), methods.end(), [&](const std::string& a, const std::string& b) {
    const Standing &p = place.at(a), &q = place.at(b);
    if (p.ratios.size() != q.ratios.size()) return p.ratios.size() > q.ratios.size();
    return p.mean() < q.mean();
  });
  return methods;
}

std::optional<HeatCell> cell_of(const Place& place, std::size_t row, std::size_t column) {
  const std::vector<std::string> ranked = ranking(place);
  if (ranked.empty()) return std::nullopt;
  const Standing& first = place.at(ranked.front());
  HeatCell cell;
  cell.row = static_cast<double>(row);
  cell.column = static_cast<double>(column);
  cell.group = ranked.front();
  cell.value = 1;
  cell.text = "only";
  cell.remark = ranked.front() + " alone solved this";
  if (ranked.size() > 1) {
    const Standing& second = place.at(ranked[1]);
    cell.value = second.mean() / first.mean();
    cell.text = padded_significant(cell.value, 2) + "×";
    cell.remark =
        ranked.front() + ": " + ranked[1] + " takes " + padded_significant(cell.value, 3) + " times as long";
    if (second.ratios.size() < first.ratios.size())
      cell.remark += " where it solves, " + std::to_string(second.ratios.size()) + " of " +
                     std::to_string(first.ratios.size()) + " cells";
  }
  for (const auto& [method, standing] : place) {
    if (standing.disagreeing == 0) continue;
    if (cell.text.back() != '!') cell.text += "!";
    cell.remark += "; " + std::to_string(standing.disagreeing) + " answers of " + method + " are refuted";
  }
  return cell;
}

std::vector<std::string> names_of(const Direction& direction) {
  std::vector<std::string> names;
  for (const auto& [order, name] : direction.values) names.push_back(name);
  return names;
}

}  // namespace

std::optional<HeatMap> fastest_picture(const Input& input) {
  std::vector<CellTimes> all;
  std::set<std::string> methods;
  for (const CellTimes& times : input.cells) {
    if (input.methods.find(times.method)->role == Role::oracle) continue;
    methods.insert(times.method);
    all.push_back(times);
  }
  if (methods.size() < 2) return std::nullopt;
  auto [columns, rows] = most_spread(directions_of(all), all);
  // Long names, and more values than stand beside each other on a phone, make rows.
  constexpr std::size_t kMostColumns = 12;
  if (columns.label == "problem" || columns.values.size() > kMostColumns) std::swap(columns, rows);

  HeatMap map;
  map.caption =
      "Who is fastest where. Colour: the method with the smallest median time. Number: how many times as "
      "long the next one takes. \"!\": answers there are refuted by proofs or by the known distance.";
  map.row_label = rows.label;
  map.column_label = columns.label;
  map.rows = names_of(rows);
  map.columns = names_of(columns);
  for (const auto& [place, standings] : places_of(all, rows, columns))
    if (std::optional<HeatCell> cell = cell_of(standings, place.first, place.second))
      map.cells.push_back(std::move(*cell));
  if (map.cells.empty()) return std::nullopt;
  return map;
}

}  // namespace raygauge::report
