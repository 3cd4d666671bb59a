// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/text_table.h"

#include <set>
#include <sstream>

#include "cli/input/input_file.h"
#include "cli/output/counted.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr const char* kBlanks = " \t\r";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

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

std::vector<std::string> cells_of(const std::string& line, const std::string& place) {
  std::vector<std::string> cells;
  for (std::size_t position = 0; position <= line.size(); ++position) {
    const std::size_t begin = std::min(line.find_first_not_of(kBlanks, position), line.size());
    if (begin == line.size() || line[begin] != '"') {
      const std::size_t comma = std::min(line.find(',', position), line.size());
      cells.push_back(trimmed(line.substr(position, comma - position)));
      position = comma;
      continue;
    }
    position = begin;
    cells.push_back(quoted_cell(line, position, place));
    const std::size_t comma = std::min(line.find(',', position), line.size());
    if (!trimmed(line.substr(position, comma - position)).empty())
      throw InvalidParameterError(place + ": a comma must follow the closing quote");
    position = comma;
  }
  return cells;
}

void check_names(const std::vector<std::string>& names, const std::string& place) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second)
      throw InvalidParameterError(place + ": the column '" + name + "' appears twice");
  }
}

}  // namespace

TextTable read_text_table(const std::string& path) {
  std::string text = read_input(path);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  std::istringstream lines(text);
  TextTable table;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = path + ":" + std::to_string(++number);
    const std::string content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    std::vector<std::string> cells = cells_of(content, place);
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
