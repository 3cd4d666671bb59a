// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/render/formats/csv_table.h"
#include "analysis/render/formats/latex_table.h"
#include "analysis/render/formats/markdown_table.h"
#include "analysis/render/formats/text_table.h"
#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

void require_rectangle(const Table& table) {
  const std::size_t columns = table.header.empty() ? 0 : table.header.front().size();
  const bool even = std::all_of(table.header.begin(), table.header.end(),
                                [&](const auto& line) { return line.size() == columns; }) &&
                    std::all_of(table.rows.begin(), table.rows.end(),
                                [&](const auto& row) { return row.cells.size() == columns; });
  if (!even || table.key_columns > columns)
    throw DimensionMismatchError("table '" + table.title + "': rows and header differ in length");
}

}  // namespace

TableCell number_cell(double value, int digits) { return {rounded_text(value, digits), value}; }

TableCell padded_cell(double value, int digits) {
  if (std::isnan(value)) return {};
  return {padded_significant(value, digits), value};
}

TableFormat table_format_from_string(const std::string& name) {
  static const std::map<std::string, TableFormat> kFormats = {{"text", TableFormat::text},
                                                              {"markdown", TableFormat::markdown},
                                                              {"latex", TableFormat::latex},
                                                              {"csv", TableFormat::csv}};
  if (const auto found = kFormats.find(name); found != kFormats.end()) return found->second;
  throw UnknownNameError("table format", name, {"text", "markdown", "latex", "csv"});
}

std::string render(const Table& table, const RenderOptions& options) {
  require_rectangle(table);
  switch (options.format) {
    case TableFormat::markdown:
      return markdown_table(table);
    case TableFormat::latex:
      return latex_table(table);
    case TableFormat::csv:
      return csv_table(table);
    case TableFormat::text:
      break;
  }
  return text_table(table, options.width, options.color);
}

}  // namespace raygauge
