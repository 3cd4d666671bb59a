// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/formats/latex_table.h"

#include "results/text/language.h"

namespace raygauge {
namespace {

std::string latex_cell(const TableCell& cell) {
  std::string text = language::latex(cell.text);
  if (text.empty()) return text;
  switch (cell.emphasis) {
    case Emphasis::strong:
    case Emphasis::alarm:
      return "\\textbf{" + text + "}";
    case Emphasis::muted:
      return "\\textit{" + text + "}";
    case Emphasis::none:
      break;
  }
  return text;
}

template <class Cells, class TextOf>
std::string latex_line(const Cells& cells, const TextOf& text_of) {
  std::string text = "  ";
  for (std::size_t c = 0; c < cells.size(); ++c) text += (c == 0 ? "" : " & ") + text_of(cells[c]);
  return text + " \\\\\n";
}

}  // namespace

std::string latex_table(const Table& table) {
  const std::size_t columns = table.header.empty() ? 0 : table.header.front().size();
  std::string text = "\\begin{table}\n\\centering\n";
  if (!table.title.empty()) text += "\\caption{" + language::latex(table.title) + "}\n";
  text += "\\begin{tabular}{" + std::string(table.key_columns, 'l') +
          std::string(columns - table.key_columns, 'r') + "}\n  \\hline\n";
  for (const auto& header : table.header) text += latex_line(header, language::latex);
  text += "  \\hline\n";
  for (const TableRow& row : table.rows) {
    if (row.starts_group && &row != &table.rows.front()) text += "  \\hline\n";
    text += latex_line(row.cells, latex_cell);
  }
  text += "  \\hline\n\\end{tabular}\n";
  if (!table.notes.empty()) text += "\n\\footnotesize\n";
  for (const std::string& note : table.notes) text += language::latex(note) + "\\par\n";
  return text + "\\end{table}\n";
}

}  // namespace raygauge
