// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/render/report/report.h"
#include "analysis/render/table.h"
#include "analysis/studies/table3/cell_ratio.h"

namespace raygauge::report {

// The blocks that a section is made of; page/*.js draws each kind. Numbers that JSON has no word for are
// null.

/// Values of columns by which a reader chooses among series or cells: {"n": "3", "tolerance": "1e-6"}.
using Facets = std::vector<std::pair<std::string, std::string>>;

/// Paragraphs, the first ones in large letters if `lead`.
Json text_block(const std::vector<std::string>& paragraphs, bool lead = false);

/// Text as it stands, in a box that folds away under `title`.
Json verbatim_block(const std::string& title, const std::string& text);

Json table_block(const Table& table);

/// A point of a series; `low` and `high` are the ends of its interval, NaN without one.
struct ChartPoint {
  double x = 0;
  double y = 0;
  double low = 0;
  double high = 0;
  std::string remark;  ///< shown beside the value
};

struct Series {
  std::string method;  ///< gives colour and marker
  std::string name;    ///< in the legend; "" for the method
  Facets facets;
  std::vector<ChartPoint> points;
};

struct Axis {
  std::string label;
  bool logarithmic = true;
};

struct Chart {
  std::string caption;
  Axis x;
  Axis y;
  bool stepped = false;  ///< a step function, without markers
  std::vector<Series> series;
};

Json chart_block(const Chart& chart);

struct HeatCell {
  Facets facets;
  double row = 0;
  double column = 0;
  double value = 0;    ///< its logarithm gives the colour
  std::string group;   ///< where not empty, the method whose colour the cell has
  std::string text;    ///< in the cell
  std::string remark;  ///< beside it, when it is pointed at
};

struct HeatMap {
  std::string caption;
  std::string row_label;
  std::string column_label;
  std::vector<HeatCell> cells;
};

Json heat_map_block(const HeatMap& map);

/// Generator with its parameters and tolerance of a cell, as a reader chooses them.
Facets problem_facets(const CellKey& cell);

/// "3.1 ms", "12 µs": 3 digits.
std::string time_words(double seconds);

}  // namespace raygauge::report
