// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/csv.h"

#include <array>
#include <charconv>
#include <cmath>

#include "results/atomic_file.h"
#include "results/schema.h"

namespace raygauge {
namespace {

std::string field(bool value) { return value ? "true" : "false"; }

std::string field(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17).ptr;
  return {buffer.data(), end};
}

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

template <class Integer>
std::string field(Integer value) {
  return std::to_string(value);
}

}  // namespace

void write_csv(const std::string& path, const std::vector<Record>& records) {
  const std::vector<Column<Record>>& columns = record_columns();
  std::string text;
  for (const Column<Record>& column : columns) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (const Record& record : records) {
    for (const Column<Record>& column : columns) {
      if (&column != &columns.front()) text += ',';
      text += std::visit([](const auto& value) { return field(value); }, column.get(record));
    }
    text += '\n';
  }
  write_atomically(path, text);
}

}  // namespace raygauge
