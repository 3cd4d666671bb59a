// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace raygauge::cli {

/// A CSV file of texts, whose first line names the columns.
struct TextTable {
  struct Row {
    std::string place;  ///< FILE:LINE
    std::vector<std::string> cells;
  };
  std::vector<std::string> names;
  std::vector<Row> rows;
};

/// The cells of one line, blanks about them dropped; a cell in quotes (RFC 4180) may hold the separator and,
/// doubled, quotes. The separator ' ' stands for any number of blanks. Throws InvalidParameterError that
/// begins with `place`.
std::vector<std::string> cells_of(const std::string& line, char separator, const std::string& place);

/// Cells are separated by commas, see cells_of. Empty lines and lines that begin with # are ignored. Throws
/// InvalidParameterError, with file and line: no line at all, a column that appears twice, a line of another
/// length, quotes left open.
TextTable read_text_table(const std::string& path);

}  // namespace raygauge::cli
