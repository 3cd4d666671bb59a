// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/formats/csv_table.h"

#include <cmath>

#include "engine/numerics/number_text.h"
#include "results/text/language.h"

namespace raygauge {
namespace {

std::string csv_header(const Table& table, std::size_t column) {
  std::string text;
  for (const auto& line : table.header) {
    if (!line[column].empty()) text += (text.empty() ? "" : " ") + line[column];
  }
  return text;
}

}  // namespace

std::string csv_table(const Table& table) {
  const std::size_t columns = table.header.empty() ? 0 : table.header.front().size();
  std::string text;
  for (std::size_t c = 0; c < columns; ++c) {
    if (c > 0) text += ',';
    text += language::csv(csv_header(table, c));
  }
  text += "\n";
  for (const TableRow& row : table.rows) {
    for (std::size_t c = 0; c < columns; ++c) {
      const TableCell& cell = row.cells[c];
      if (c > 0) text += ',';
      text += std::isnan(cell.number) ? language::csv(cell.text) : shortest_text(cell.number);
    }
    text += "\n";
  }
  return text;
}

}  // namespace raygauge
