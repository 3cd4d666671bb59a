// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace raygauge {

enum class Emphasis : std::uint8_t {
  none,
  strong,  ///< the value to look at first
  muted,   ///< quoted for comparison
  alarm,   ///< something is wrong
};

struct TableCell {
  TableCell() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a text is a cell
  TableCell(std::string words, Emphasis how = Emphasis::none) : text(std::move(words)), emphasis(how) {}
  TableCell(std::string words, double value, Emphasis how = Emphasis::none)
      : text(std::move(words)), number(value), emphasis(how) {}

  std::string text;
  double number = std::numeric_limits<double>::quiet_NaN();  ///< what CSV writes in full; NaN: the text
  Emphasis emphasis = Emphasis::none;
};

struct TableRow {
  std::vector<TableCell> cells;
  bool starts_group = false;  ///< set apart from the row above
};

/// A number with at most so many significant digits.
TableCell number_cell(double value, int digits = 6);

/// A number with exactly so many, as padded_significant(); empty for NaN.
TableCell padded_cell(double value, int digits);

/// A table in no particular format. All header lines and rows have the same number of cells.
struct Table {
  std::string title;
  std::vector<std::vector<std::string>> header;  ///< lines, read from top to bottom in each column
  std::size_t key_columns = 1;                   ///< the first columns, which say what the row is
  std::vector<TableRow> rows;
  std::vector<std::string> notes;  ///< sentences below the table
};

/// A table that compares `items`, each a column headed by `name_of` it; rows are to be added by
/// add_summary_row().
template <class Items, class NameOf>
Table summary_table(const std::string& title, const Items& items, const NameOf& name_of) {
  Table table;
  table.title = title;
  table.header = {{""}};
  for (const auto& item : items) table.header[0].push_back(name_of(item));
  return table;
}

/// A row of `cell_of` each item.
template <class Items, class CellOf>
void add_summary_row(Table& table, const std::string& what, const Items& items, const CellOf& cell_of) {
  TableRow row{{{what}}, false};
  for (const auto& item : items) row.cells.push_back(cell_of(item));
  table.rows.push_back(std::move(row));
}

enum class TableFormat : std::uint8_t { text, markdown, latex, csv };

/// "text", "markdown", …. Throws UnknownNameError, which lists them.
TableFormat table_format_from_string(const std::string& name);

struct RenderOptions {
  TableFormat format = TableFormat::text;
  std::size_t width =
      0;               ///< text: columns of the terminal, beyond which the table is continued below; 0: any
  bool color = false;  ///< text: emphasis by ANSI escapes
};

/// The table as text of that format, ending in a newline. CSV has neither title nor notes. Throws
/// DimensionMismatchError if the rows are not of equal length.
std::string render(const Table& table, const RenderOptions& options = {});

}  // namespace raygauge
