// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace raygauge {

/// One entry of a column.
using Value = std::variant<bool, std::int32_t, std::int64_t, std::uint64_t, double, std::string>;

/// The type of a column: the index of its entries in Value.
enum class ValueType : std::uint8_t { boolean, int32, int64, uint64, float64, text };

/// "int32", "float64", …: the word for the type in the documentation.
std::string_view to_string(ValueType type) noexcept;

inline ValueType type_of(const Value& value) noexcept { return static_cast<ValueType>(value.index()); }

/// The type of the column that holds a C++ type.
template <class T, std::size_t i = 0>
constexpr ValueType value_type() noexcept {
  if constexpr (std::is_same_v<T, std::variant_alternative_t<i, Value>>) {
    return static_cast<ValueType>(i);
  } else {
    return value_type<T, i + 1>();
  }
}

/// What a column is called and what its entries mean.
struct ColumnInfo {
  std::string name;
  std::string unit;  ///< "s", "B", "1" for a pure number or a count, "" for text and booleans
  std::string description;
  ValueType type = ValueType::float64;
};

/// A column of a table of `Row`s: a ColumnInfo and how to read and set the entry of one row.
template <class Row>
struct Column : ColumnInfo {
  std::function<Value(const Row&)> get;
  std::function<void(Row&, const Value&)> set;  ///< the value must hold `type`

  /// The entry of every row of a file that lacks the column; nothing for a column that every file has had.
  std::optional<Value> absent = {};

  std::string former_name = {};  ///< in files of earlier versions; empty where it is today's
};

/// The column of a data member, or of a member of a member.
template <class Row, class T>
Column<Row> column(std::string name, std::string unit, std::string description, T Row::*member) {
  return {{std::move(name), std::move(unit), std::move(description), value_type<T>()},
          [member](const Row& row) { return Value(row.*member); },
          [member](Row& row, const Value& value) { row.*member = std::get<T>(value); }};
}

template <class Row, class Part, class T>
Column<Row> column(std::string name, std::string unit, std::string description, Part Row::*part,
                   T Part::*member) {
  return {{std::move(name), std::move(unit), std::move(description), value_type<T>()},
          [part, member](const Row& row) { return Value(row.*part.*member); },
          [part, member](Row& row, const Value& value) { row.*part.*member = std::get<T>(value); }};
}

/// A column that files of earlier versions lack: `absent` stands for its entries there.
template <class Row>
Column<Row> later(Column<Row> column, Value absent) {
  column.absent = std::move(absent);
  return column;
}

/// A column that files of earlier versions call `name`.
template <class Row>
Column<Row> formerly(std::string name, Column<Row> column) {
  column.former_name = std::move(name);
  return column;
}

}  // namespace raygauge
