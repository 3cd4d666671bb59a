// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/table.h"

namespace raygauge::report {

// The blocks that a section is made of, as data: blocks_json.h writes them into the page, page/*.js draws
// each kind.

/// Values of columns by which a reader chooses among series or cells: {"n": "3", "tolerance": "1e-6"}.
using Facets = std::vector<std::pair<std::string, std::string>>;

/// Paragraphs, the first ones in large letters if `lead`.
struct Text {
  std::vector<std::string> paragraphs;
  bool lead = false;
};

/// Text as it stands, in a box that folds away under `title`.
struct Verbatim {
  std::string title;
  std::string text;
};

/// A point of a series; `low` and `high` are the ends of its interval, NaN without one.
struct ChartPoint {
  double x = 0;
  double y = 0;
  double low = 0;
  double high = 0;
  std::string remark;   ///< shown beside the value
  bool flawed = false;  ///< crossed: answers behind it are wrong or missing
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
  std::string unit;  ///< of the values, shown with them; "" for none
};

struct Chart {
  std::string caption;
  Axis x;
  Axis y;
  bool stepped = false;  ///< a step function, without markers
  std::vector<Series> series;
};

struct HeatCell {
  Facets facets;
  double row = 0;      ///< a value, or the number of a name in HeatMap::rows
  double column = 0;   ///< alike
  double value = 0;    ///< gives the colour
  std::string group;   ///< where not empty, the method whose colour the cell has
  std::string text;    ///< in the cell
  std::string remark;  ///< beside it, when it is pointed at
};

struct HeatMap {
  std::string caption;
  std::string row_label;
  std::string column_label;
  std::string value_label;        ///< beside the scale of colours
  std::vector<std::string> rows;  ///< names of the rows; empty where they are numbers
  std::vector<std::string> columns;
  bool logarithmic = true;  ///< the colours; otherwise from 0 to 1
  std::vector<HeatCell> cells;
};

/// The records themselves, which the page offers for download as a CSV file; or, where they are too many for
/// a page, their number.
struct RecordsDownload {
  std::size_t count = 0;
  std::string name;
  int time_digits = 0;  ///< significant digits of its times
  std::string gzip;     ///< its columns, one below the other, compressed, in base64; "" for too many
};

using Block = std::variant<Text, Verbatim, Table, Chart, HeatMap, RecordsDownload>;

/// Generator with its parameters and tolerance of a cell, as a reader chooses them.
Facets problem_facets(const CellKey& cell);

/// "3.1 ms", "12 µs": 3 digits.
std::string time_words(double seconds);

}  // namespace raygauge::report
