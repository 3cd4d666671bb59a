// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace raygauge::cli {

/// A CSV file of numbers, whose first line may name the columns.
struct NumberTable {
  std::string path;
  std::vector<std::string> names;  ///< empty: no line of names
  Eigen::MatrixXd rows;            ///< one row a line

  /// The number of the column of that name. Throws InvalidParameterError, naming file and column.
  Eigen::Index column(const std::string& name) const;
};

/// Throws as read_point_file does.
NumberTable read_number_table(const std::string& path);

}  // namespace raygauge::cli
