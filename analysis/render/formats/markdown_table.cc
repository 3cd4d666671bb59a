// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/formats/markdown_table.h"

#include "results/text/language.h"

namespace raygauge {
namespace {

std::string markdown_cell(const TableCell& cell) {
  std::string text = language::markdown(cell.text);
  if (text.empty()) return text;
  switch (cell.emphasis) {
    case Emphasis::strong:
    case Emphasis::alarm:
      return "**" + text + "**";
    case Emphasis::muted:
      return "*" + text + "*";
    case Emphasis::none:
      break;
  }
  return text;
}

/// The header's lines of one column as one cell.
std::string markdown_header(const Table& table, std::size_t column) {
  std::string text;
  for (const auto& line : table.header) {
    if (line[column].empty()) continue;
    text += (text.empty() ? "" : "<br>") + language::markdown(line[column]);
  }
  return text;
}

}  // namespace

std::string markdown_table(const Table& table) {
  std::string text;
  if (!table.title.empty()) text += "**" + language::markdown(table.title) + "**\n\n";
  const std::size_t columns = table.header.empty() ? 0 : table.header.front().size();
  std::string rule = "|";
  text += "|";
  for (std::size_t c = 0; c < columns; ++c) {
    text.append(" ").append(markdown_header(table, c)).append(" |");
    rule += c < table.key_columns ? " --- |" : " ---: |";
  }
  text += "\n" + rule + "\n";
  for (const TableRow& row : table.rows) {
    text += "|";
    for (const TableCell& cell : row.cells) text.append(" ").append(markdown_cell(cell)).append(" |");
    text += "\n";
  }
  if (!table.notes.empty()) text += "\n";
  for (const std::string& note : table.notes) text.append("- ").append(language::markdown(note)).append("\n");
  return text;
}

}  // namespace raygauge
