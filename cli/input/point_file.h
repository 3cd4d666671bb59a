// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <string_view>

namespace raygauge::cli {

/// How a text is to be read.
struct PointFormat {
  bool skip_header = false;  ///< the first line with content is a heading, unless it begins with a number
  std::string header_option =
      {};  ///< what skips a heading where the text comes from, for messages; "": nothing
  double streamed_from = std::numeric_limits<double>::infinity();  ///< bytes of a dataset: see open_streamed
};

/// The points that a text holds, one a line, as the columns of an n × N matrix.
///
/// Coordinates are separated by a comma, a semicolon, blanks or tabs; `#` starts a comment; blank lines are
/// ignored; a line that has commas beside semicolons or blanks is refused, for they may be decimal commas; a
/// UTF-8 byte order mark and line ends of any system are accepted. Numbers too small for double
/// precision become 0.
///
/// `name` is what messages call the text. Throws InvalidParameterError for what is not a number, a missing
/// coordinate or lines of different length, NonFiniteError for NaN, infinity or overflow, and EmptySetError
/// where there is no point; messages name the line and, but for ragged lines, the column (both from 1;
/// columns count bytes).
Eigen::MatrixXd parse_points(std::string_view text, const std::string& name, const PointFormat& format = {});

/// The points of a text file, or of standard input for "-", read block by block. Throws as parse_points and
/// read_input do.
Eigen::MatrixXd read_point_file(const std::string& path, const PointFormat& format = {});

}  // namespace raygauge::cli
