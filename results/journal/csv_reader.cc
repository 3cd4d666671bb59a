// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <system_error>

#include "results/exceptions.h"
#include "results/journal/csv.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace {

/// Takes fields off the front of CSV rows.
class FieldReader {
 public:
  explicit FieldReader(std::string_view rows) : rest_(rows) {}

  bool at_end() const noexcept { return rest_.empty(); }

  /// The next field, which `end` must follow: a comma, or LF after the last of its row.
  std::string take(char end) {
    std::string field = rest_.starts_with('"') ? take_quoted() : take_plain();
    if (!rest_.starts_with(end)) {
      throw ResultsError(end == ',' ? "no comma follows it" : "the row does not end with it");
    }
    rest_.remove_prefix(1);
    return field;
  }

 private:
  std::string take_plain() {
    const std::size_t length = std::min(rest_.find_first_of(",\n"), rest_.size());
    std::string field(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return field;
  }

  /// A quote within quotes is doubled.
  std::string take_quoted() {
    std::string field;
    for (rest_.remove_prefix(1); !rest_.empty(); rest_.remove_prefix(1)) {
      if (rest_.starts_with("\"\"")) {
        rest_.remove_prefix(1);
      } else if (rest_.starts_with('"')) {
        rest_.remove_prefix(1);
        return field;
      }
      field += rest_.front();
    }
    throw ResultsError("its quotes are not closed");
  }

  std::string_view rest_;
};

[[noreturn]] void refuse(const std::string& field, ValueType type) {
  throw ResultsError("'" + field + "' is not of type " + std::string(to_string(type)));
}

template <class Number>
Value number_of(const std::string& field) {
  Number number{};
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, number);
  if (error != std::errc() || stop != end) refuse(field, value_type<Number>());
  return number;
}

Value value_of(std::string field, ValueType type) {
  switch (type) {
    case ValueType::boolean:
      if (field != "true" && field != "false") refuse(field, type);
      return field == "true";
    case ValueType::int32:
      return number_of<std::int32_t>(field);
    case ValueType::int64:
      return number_of<std::int64_t>(field);
    case ValueType::uint64:
      return number_of<std::uint64_t>(field);
    case ValueType::float64:
      return number_of<double>(field);
    case ValueType::text:
      return field;
  }
  refuse(field, type);
}

}  // namespace

CsvColumns csv_columns(std::string_view header, const std::vector<Column<Record>>& known) {
  CsvColumns columns;
  for (const Column<Record>& column : known) {
    // Columns are only ever added, so those of an older file stand in the order of today's.
    const std::string_view name = header.substr(0, header.find_first_of(",\n"));
    if (name == column.name) {
      columns.present.push_back(&column);
      header.remove_prefix(std::min(name.size() + 1, header.size()));
    } else if (column.absent) {
      columns.absent.push_back(&column);
    } else {
      throw ResultsError("column " + column.name + " is missing");
    }
  }
  if (!header.empty())
    throw ResultsError("column " + std::string(header.substr(0, header.find_first_of(",\n"))) +
                       " is not known");
  return columns;
}

std::vector<Record> read_csv_rows(std::string_view rows, const CsvColumns& columns) {
  std::vector<Record> records;
  for (FieldReader fields(rows); !fields.at_end();) {
    Record& record = records.emplace_back();
    for (const Column<Record>* column : columns.absent) column->set(record, *column->absent);
    for (const Column<Record>* column : columns.present) {
      try {
        column->set(record,
                    value_of(fields.take(column == columns.present.back() ? '\n' : ','), column->type));
      } catch (const Error& error) {
        throw ResultsError("row " + std::to_string(records.size()) + ", column " + column->name + ": " +
                           error.what());
      }
    }
  }
  return records;
}

std::vector<Record> read_csv_rows(std::string_view rows) {
  static const CsvColumns kColumns = csv_columns(csv_header(), record_columns());
  return read_csv_rows(rows, kColumns);
}

}  // namespace raygauge
