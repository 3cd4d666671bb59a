// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/schema/column.h"

namespace raygauge {

/// `records` as CSV: a header line of the column names of record_columns(), then one line a record.
/// Numbers have 17 significant digits (every double survives), infinities and NaN are `inf`, `-inf`, `nan`,
/// booleans `true` and `false`; texts are quoted after RFC 4180 where they need it; lines end in LF.
/// `time_digits` are the significant digits of columns in seconds: fewer of them compress better.
std::string csv_text(const std::vector<Record>& records, int time_digits = 17);

/// The same fields, one a line: of each column its name, then its fields, then an empty line. Equal fields
/// stand together, so that it packs better.
std::string csv_columns(const std::vector<Record>& records, int time_digits = 17);

/// Its two parts: the header line, and the lines of the records.
std::string csv_header();
std::string csv_rows(const std::vector<Record>& records, int time_digits = 17);

/// One field of it.
std::string csv_field(const Value& value);

/// Any table as CSV, but for a column `left_out`; entry(column, row) is a field.
template <class Row, class Entry>
std::string csv_table(const std::vector<Column<Row>>& columns, const std::vector<Row>& rows,
                      const Entry& entry, std::string_view left_out = "") {
  std::string text;
  for (const Column<Row>& column : columns)
    if (column.name != left_out) text += column.name + ',';
  text.back() = '\n';
  for (const Row& row : rows) {
    for (const Column<Row>& column : columns)
      if (column.name != left_out) text += entry(column, row) + ',';
    text.back() = '\n';
  }
  return text;
}

/// The inverse of csv_rows(), bit for bit where it wrote all digits. Throws ResultsError that names row (from
/// 1) and column: "row 3, column seconds: 'soon' is not of type float64".
std::vector<Record> read_csv_rows(std::string_view rows);

/// The columns of a CSV file, by its header line.
struct CsvColumns {
  std::vector<const Column<Record>*> present;  ///< in the order of the file
  std::vector<const Column<Record>*> absent;   ///< added by later versions: they get Column::absent
};

/// Which of `columns` a file with this header line has. Throws ResultsError for one that no version wrote.
CsvColumns csv_columns(std::string_view header, const std::vector<Column<Record>>& columns);
std::vector<Record> read_csv_rows(std::string_view rows, const CsvColumns& columns);

}  // namespace raygauge
