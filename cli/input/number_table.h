// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace raygauge::cli {

/// A CSV file of numbers with a heading that names the columns, in any order.
struct NumberTable {
  std::string path;
  std::string heading;             ///< FILE:LINE of it
  std::vector<std::string> names;  ///< empty: no heading
  Eigen::MatrixXd rows;            ///< one row a line
  std::vector<std::size_t> lines;  ///< of each row, from 1

  /// The number of the column of that name. Throws InvalidParameterError, naming file and column.
  Eigen::Index column(const std::string& name) const;

  /// FILE:LINE of a row.
  std::string place(Eigen::Index row) const;
};

/// The heading is the first line that is neither blank nor a comment, unless it begins with a number; without
/// one, the last comment above the numbers that names the column `key` and as many as there are. Names are
/// separated by what separates the numbers, and may be quoted; they may hold blanks where these do not
/// separate. Throws as parse_points does, with file and line: also for two columns of one name and for as
/// many names as there are no columns.
NumberTable read_number_table(const std::string& path, const std::string& key);

/// Throws InvalidParameterError, with file and line, unless the numbers of the column rise.
void require_rising(const NumberTable& table, const std::string& name);

}  // namespace raygauge::cli
