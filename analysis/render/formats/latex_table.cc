// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/formats/latex_table.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

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

// What a page of LaTeX's own classes takes, in points; and, from above, what a letter does.
constexpr double kLineWidth = 345;
constexpr double kLetter = 5.3;
constexpr double kSmallLetter = 4.6;
constexpr double kBold = 1.15;
constexpr double kBetweenColumns = 12;
constexpr double kBetweenSmallColumns = 6;
constexpr std::size_t kLines = 38;
constexpr std::size_t kSmallLines = 48;
constexpr std::size_t kNoteLetters = 85;  // a line of a note
constexpr double kWidestKey = 120;        // a text of more is broken

double letters_of(const std::string& text) {
  return static_cast<double>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The width of each column without what stands between them.
std::vector<double> widths_of(const Table& table, double letter) {
  std::vector<double> widths(table.header.empty() ? 0 : table.header.front().size(), 0.0);
  for (const auto& header : table.header) {
    for (std::size_t c = 0; c < header.size(); ++c)
      widths[c] = std::max(widths[c], letter * letters_of(header[c]));
  }
  for (const TableRow& row : table.rows) {
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const bool bold = row.cells[c].emphasis == Emphasis::strong || row.cells[c].emphasis == Emphasis::alarm;
      widths[c] = std::max(widths[c], (bold ? kBold : 1) * letter * letters_of(row.cells[c].text));
    }
  }
  return widths;
}

/// How a table is made to fit: small letters, parts of so many columns, parts of so many rows.
struct Layout {
  bool small = false;
  std::vector<double> widths;
  double between = kBetweenColumns;
  std::size_t rows = kLines;
};

Layout layout_of(const Table& table) {
  Layout layout;
  layout.widths = widths_of(table, kLetter);
  const double all = std::accumulate(layout.widths.begin(), layout.widths.end(), 0.0) +
                     layout.between * static_cast<double>(layout.widths.size());
  std::size_t notes = 0;
  for (const std::string& note : table.notes) notes += 1 + note.size() / kNoteLetters;
  layout.small = all > kLineWidth || table.rows.size() + notes > kLines;
  if (layout.small) {
    layout.widths = widths_of(table, kSmallLetter);
    layout.between = kBetweenSmallColumns;
    layout.rows = kSmallLines;
  }
  for (std::size_t c = 0; c < table.key_columns; ++c)
    layout.widths[c] = std::min(layout.widths[c], kWidestKey);
  constexpr std::size_t kFewest = 10;
  if (table.rows.size() + notes > layout.rows) layout.rows -= std::min(notes, layout.rows - kFewest);
  return layout;
}

/// The end of the columns from `first` on that fit beside the keys; at least one.
std::size_t last_column(const Layout& layout, std::size_t keys, std::size_t first) {
  double width = 0;
  for (std::size_t c = 0; c < keys; ++c) width += layout.widths[c] + layout.between;
  std::size_t end = first;
  while (end < layout.widths.size()) {
    width += layout.widths[end] + layout.between;
    if (width > kLineWidth && end > first) break;
    ++end;
  }
  return end;
}

/// The keys and the columns of a part.
template <class Cells, class TextOf>
std::string latex_line(const Cells& cells, std::size_t keys, std::pair<std::size_t, std::size_t> part,
                       const TextOf& text_of) {
  std::string text;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (c < keys || (c >= part.first && c < part.second))
      text += (text.empty() ? "  " : " & ") + text_of(cells[c]);
  }
  return text + " \\\\\n";
}

std::string column_types(const Table& table, const Layout& layout, std::pair<std::size_t, std::size_t> part) {
  std::string types;
  for (std::size_t c = 0; c < table.key_columns; ++c) {
    const bool broken = layout.widths[c] >= kWidestKey;
    types += broken ? "p{" + std::to_string(static_cast<int>(kWidestKey)) + "pt}" : "l";
  }
  return types + std::string(part.second - part.first, 'r');
}

std::string part_text(const Table& table, const Layout& layout, std::pair<std::size_t, std::size_t> columns,
                      std::pair<std::size_t, std::size_t> rows, bool ends) {
  const bool begins = rows.first == 0 && columns.first <= table.key_columns;
  std::string text = "\\begin{table}\n\\centering\n";
  if (!table.title.empty())
    text += "\\caption{" + language::latex(table.title) + (begins ? "" : " (continued)") + "}\n";
  if (layout.small) text += "\\footnotesize\\setlength{\\tabcolsep}{3pt}\n";
  text += "\\begin{tabular}{" + column_types(table, layout, columns) + "}\n  \\hline\n";
  for (const auto& header : table.header)
    text += latex_line(header, table.key_columns, columns, language::latex);
  text += "  \\hline\n";
  for (std::size_t r = rows.first; r < rows.second; ++r) {
    if (table.rows[r].starts_group && r > rows.first) text += "  \\hline\n";
    text += latex_line(table.rows[r].cells, table.key_columns, columns, latex_cell);
  }
  text += "  \\hline\n\\end{tabular}\n";
  if (ends && !table.notes.empty()) text += "\n\\footnotesize\n";
  if (ends) {
    for (const std::string& note : table.notes) text += language::latex(note) + "\\par\n";
  }
  return text + "\\end{table}\n";
}

}  // namespace

std::string latex_table(const Table& table) {
  const Layout layout = layout_of(table);
  std::string text;
  const std::size_t columns = widths_of(table, 1).size();
  std::size_t first_row = 0;
  do {
    const std::size_t last_row = std::min(first_row + layout.rows, table.rows.size());
    for (std::size_t c = table.key_columns; c == table.key_columns || c < columns;) {
      const std::size_t end = last_column(layout, table.key_columns, c);
      const bool ends = end >= columns && last_row == table.rows.size();
      text += (text.empty() ? "" : "\n") + part_text(table, layout, {c, end}, {first_row, last_row}, ends);
      c = std::max(end, table.key_columns + 1);
    }
    first_row = last_row;
  } while (first_row < table.rows.size());
  return text;
}

}  // namespace raygauge
