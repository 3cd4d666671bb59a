// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/number_table.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/number_word.h"
#include "cli/input/point_file.h"
#include "cli/input/text_table.h"
#include "raygauge/exceptions.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// What separates the cells of a line: the first of these that it has outside quotes, else blanks.
char separator_of(std::string_view line) {
  for (const char separator : {',', ';', '\t'}) {
    bool in_quotes = false;
    for (const char c : line) {
      if (c == '"') in_quotes = !in_quotes;
      if (c == separator && !in_quotes) return separator;
    }
  }
  return ' ';
}

/// Names of columns, and the line that has them.
struct Heading {
  std::vector<std::string> names;
  std::size_t line = 0;  ///< from 1
  std::size_t at = 0;    ///< where it begins in the text
};

/// The names in a comment, if they are names of columns: `key` is among them.
std::vector<std::string> names_in_comment(std::string_view comment, const std::string& key) {
  const std::string text(trimmed(comment.substr(1)));
  if (std::count(text.begin(), text.end(), '"') % 2 != 0) return {};
  std::vector<std::string> names = cells_of(text, separator_of(text), "");
  return std::find(names.begin(), names.end(), key) == names.end() ? std::vector<std::string>() : names;
}

/// Calls take(line without blanks about it, where it begins, its number from 1) for each line that is not
/// blank.
template <class Take>
void for_each_line(std::string_view text, const Take& take) {
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    ++number;
    if (!line.empty()) take(line, at, number);
    at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
  }
}

/// Finds the heading of a text, and the lines below it that hold numbers. A comment is one only if it has as
/// many names as the numbers have columns.
Heading find_heading(std::string_view text, const std::string& key, const std::string& path,
                     std::vector<std::size_t>& lines) {
  std::vector<Heading> comments;
  Heading heading;
  for_each_line(text, [&](std::string_view line, std::size_t at, std::size_t number) {
    const bool above = lines.empty() && heading.names.empty();
    if (line.front() == '#') {
      if (above) comments.push_back({names_in_comment(line, key), number, at});
      return;
    }
    if (above) {
      std::vector<std::string> cells =
          cells_of(std::string(line), separator_of(line), path + ":" + std::to_string(number));
      if (!number_of(cells.front())) {
        heading = {std::move(cells), number, at};
        return;
      }
      const auto fits = [&](const Heading& comment) { return comment.names.size() == cells.size(); };
      const auto last = std::find_if(comments.rbegin(), comments.rend(), fits);
      if (last != comments.rend()) heading = *last;
    }
    lines.push_back(number);
  });
  return heading;
}

void check_names(const NumberTable& table) {
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    if (name.empty())
      throw InvalidParameterError(table.heading + ": column " + std::to_string(i + 1) + " has no name");
    if (std::find(table.names.begin(), table.names.begin() + static_cast<std::ptrdiff_t>(i), name) !=
        table.names.begin() + static_cast<std::ptrdiff_t>(i))
      throw InvalidParameterError(table.heading + ": the column '" + name + "' appears twice");
  }
  if (table.rows.cols() == static_cast<Eigen::Index>(table.names.size())) return;
  throw InvalidParameterError(table.heading + ": " + counted(table.names.size(), "name") +
                              " of columns, but " + counted(table.rows.cols(), "column"));
}

}  // namespace

Eigen::Index NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return found - names.begin();
  throw InvalidParameterError((names.empty() ? path : heading) + ": there is no column '" + name + "'");
}

std::string NumberTable::place(Eigen::Index row) const {
  return path + ":" + std::to_string(lines[static_cast<std::size_t>(row)]);
}

NumberTable read_number_table(const std::string& path, const std::string& key) {
  std::string text = read_text_input(path);
  NumberTable table;
  table.path = path;
  const Heading heading = find_heading(text, key, path, table.lines);
  table.names = heading.names;
  table.heading = path + ":" + std::to_string(heading.line);
  if (!table.names.empty()) text.insert(heading.at, "#");  // a comment from here on: lines keep their numbers
  table.rows = parse_points(text, path).transpose();
  if (!table.names.empty()) check_names(table);
  return table;
}

void require_rising(const NumberTable& table, const std::string& name) {
  const auto column = table.rows.col(table.column(name));
  for (Eigen::Index i = 1; i < column.size(); ++i) {
    if (column[i] > column[i - 1]) continue;
    std::ostringstream text;
    text << table.place(i) << ": " << name << "s must rise, but " << column[i] << " comes after "
         << column[i - 1];
    throw InvalidParameterError(text.str());
  }
}

}  // namespace raygauge::cli
