// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/number_table.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "cli/input/input_file.h"
#include "cli/input/point_file.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

// Whether the line begins with a letter and is no number such as nan or inf.
bool names_columns(const std::string& line) {
  const auto first = std::find_if(line.begin(), line.end(), [](unsigned char c) { return !std::isspace(c); });
  if (first == line.end() || (!std::isalpha(static_cast<unsigned char>(*first)) && *first != '_'))
    return false;
  const std::string word(first, std::min(first + 3, line.end()));
  return word != "nan" && word != "NaN" && word != "inf" && word != "Inf";
}

std::vector<std::string> split(const std::string& line) {
  std::string blanks = line;
  std::replace_if(
      blanks.begin(), blanks.end(), [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\r'; },
      ' ');
  std::istringstream words(blanks);
  std::vector<std::string> names;
  for (std::string name; words >> name;) names.push_back(name);
  return names;
}

}  // namespace

Eigen::Index NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return found - names.begin();
  throw InvalidParameterError(path + ": there is no column '" + name + "'");
}

NumberTable read_number_table(const std::string& path) {
  std::string text = read_input(path);
  NumberTable table;
  table.path = path;
  const std::string first_line = text.substr(0, text.find('\n'));
  if (names_columns(first_line)) {
    table.names = split(first_line);
    text.insert(0, "#");  // a comment from here on, so that lines keep their numbers
  }
  table.rows = parse_points(text, path).transpose();
  if (!table.names.empty() && table.rows.cols() != static_cast<Eigen::Index>(table.names.size())) {
    throw InvalidParameterError(path + ": " + std::to_string(table.names.size()) + " names of columns, but " +
                                std::to_string(table.rows.cols()) + " columns");
  }
  return table;
}

}  // namespace raygauge::cli
