// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/text_table.h"

#include <set>
#include <sstream>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

constexpr const char* kBlanks = " \t\r";

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The quoted cell whose opening quote is at `position`, which is then behind the closing one.
std::string quoted_cell(const std::string& line, std::size_t& position, const std::string& place) {
  std::string cell;
  for (++position; position < line.size(); ++position) {
    if (line[position] != '"') {
      cell += line[position];
    } else if (position + 1 < line.size() && line[position + 1] == '"') {
      cell += line[position++];
    } else {
      ++position;
      return cell;
    }
  }
  throw InvalidParameterError(place + ": a quote that opens here is never closed");
}

void check_names(const std::vector<std::string>& names, const std::string& place) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second)
      throw InvalidParameterError(place + ": the column '" + name + "' appears twice");
  }
}

/// Where the cell ends that is no quoted one, or what stands behind a quoted one.
std::size_t end_of_cell(const std::string& line, std::size_t position, char separator) {
  return std::min(separator == ' ' ? line.find_first_of(kBlanks, position) : line.find(separator, position),
                  line.size());
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line, char separator, const std::string& place) {
  std::vector<std::string> cells;
  const char* const blanks = separator == '\t' ? " \r" : kBlanks;
  for (std::size_t position = 0; position <= line.size(); ++position) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks, position), line.size());
    if (separator == ' ') position = begin;
    if (begin == line.size() || line[begin] != '"') {
      const std::size_t end = end_of_cell(line, position, separator);
      cells.push_back(trimmed(line.substr(position, end - position)));
      position = end;
      continue;
    }
    position = begin;
    cells.push_back(quoted_cell(line, position, place));
    const std::size_t end = end_of_cell(line, position, separator);
    if (!trimmed(line.substr(position, end - position)).empty())
      throw InvalidParameterError(place + ": a " + (separator == ',' ? "comma" : "separator") +
                                  " must follow the closing quote");
    position = end;
  }
  return cells;
}

TextTable read_text_table(const std::string& path) {
  std::istringstream lines(read_text_input(path));
  TextTable table;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = path + ":" + std::to_string(++number);
    const std::string content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    std::vector<std::string> cells = cells_of(content, ',', place);
    if (table.names.empty()) {
      check_names(cells, place);
      table.names = std::move(cells);
    } else if (cells.size() == table.names.size()) {
      table.rows.push_back({place, std::move(cells)});
    } else {
      throw InvalidParameterError(place + ": " + counted(cells.size(), "cell") +
                                  " where the first line names " + counted(table.names.size(), "column"));
    }
  }
  if (table.rows.empty()) throw InvalidParameterError(path + ": no lines below one that names the columns");
  return table;
}

}  // namespace raygauge::cli
