// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/journal/csv.h"

#include <array>
#include <charconv>
#include <cmath>

#include "engine/numerics/number_text.h"
#include "results/schema/schema.h"
#include "results/text/language.h"

namespace raygauge {

namespace {

constexpr int kAllDigits = 17;

std::string real_field(double value, int digits) {
  if (std::isnan(value)) return "nan";
  if (digits == kAllDigits) return shortest_text(value);
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits)
          .ptr;
  return {buffer.data(), end};
}

/// A value of a column as it stands in CSV.
struct Field {
  int digits = kAllDigits;
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return real_field(value, digits); }
  std::string operator()(const std::string& text) const { return language::csv(text); }
  template <class Integer>
  std::string operator()(Integer value) const {
    return std::to_string(value);
  }
};

}  // namespace

std::string csv_field(const Value& value) { return std::visit(Field{}, value); }

std::string csv_header() {
  std::string text;
  for (const Column<Record>& column : record_columns()) text += (text.empty() ? "" : ",") + column.name;
  return text + '\n';
}

std::string csv_rows(const std::vector<Record>& records, int time_digits) {
  const std::vector<Column<Record>>& columns = record_columns();
  std::string text;
  for (const Record& record : records) {
    for (const Column<Record>& column : columns) {
      if (&column != &columns.front()) text += ',';
      text += std::visit(Field{column.unit == "s" ? time_digits : kAllDigits}, column.get(record));
    }
    text += '\n';
  }
  return text;
}

std::string csv_text(const std::vector<Record>& records, int time_digits) {
  return csv_header() + csv_rows(records, time_digits);
}

std::string csv_columns(const std::vector<Record>& records, int time_digits) {
  std::string text;
  for (const Column<Record>& column : record_columns()) {
    const Field field{column.unit == "s" ? time_digits : kAllDigits};
    text += column.name + '\n';
    for (const Record& record : records) text += std::visit(field, column.get(record)) + '\n';
    text += '\n';
  }
  return text;
}

}  // namespace raygauge
