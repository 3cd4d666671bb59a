// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "raygauge/sweep/record.h"

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

/// Entries of a column as they lie in memory, one behind the other: numbers as they are, truths as a byte,
/// texts in `width` bytes each, padded with zeros. They belong to somebody else.
struct StoredEntries {
  const char* bytes = nullptr;
  std::size_t width = 0;  ///< of an entry
  std::size_t count = 0;

  template <class T>
  T number(std::size_t i) const {
    T value;
    std::memcpy(&value, bytes + i * width, sizeof value);
    return value;
  }
  bool truth(std::size_t i) const { return bytes[i * width] != 0; }
  std::string_view text(std::size_t i) const {
    const char* entry = bytes + i * width;
    const std::size_t end = ::strnlen(entry, width);
    const bool zeros_follow = end == width || std::memcmp(entry + end, entry + end + 1, width - end - 1) == 0;
    const std::string_view whole(entry, width);
    return whole.substr(0, zeros_follow ? end : whole.find_last_not_of('\0') + 1);
  }
};

/// A column of a table of `Row`s: a ColumnInfo and how to read and set the entry of one row.
template <class Row>
struct Column : ColumnInfo {
  std::function<Value(const Row&)> get;
  std::function<void(Row&, const Value&)> set;  ///< the value must hold `type`

  /// The entry of every row of a file that lacks the column; nothing for a column that every file has had.
  std::optional<Value> absent = {};

  /// What `set` does, for a row from each of the entries; where it is empty, `set` is called for each.
  std::function<void(std::span<Row>, const StoredEntries&)> set_all = {};
};

/// Column::set_all of the member that `member_of` finds in a row.
template <class Row, class T, class MemberOf>
auto setter_of_all(MemberOf member_of) {
  return [member_of](std::span<Row> rows, const StoredEntries& entries) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if constexpr (std::is_same_v<T, std::string>) {
        member_of(rows[i]) = entries.text(i);
      } else if constexpr (std::is_same_v<T, bool>) {
        member_of(rows[i]) = entries.truth(i);
      } else {
        member_of(rows[i]) = entries.number<T>(i);
      }
    }
  };
}

/// Finds the shared text of one entry after another. Entries take turns among a few texts.
class SharedTextFinder {
 public:
  SharedText operator()(std::string_view text) {
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (++next_ >= known_.size()) next_ = 0;
      if (known_[next_] == text) return known_[next_];
    }
    if (known_.size() < kKnown) {
      next_ = known_.size();
      known_.emplace_back();
    } else if (++next_ == kKnown) {
      next_ = 0;
    }
    return known_[next_] = text;
  }

 private:
  static constexpr std::size_t kKnown = 16;
  std::vector<SharedText> known_;
  std::size_t next_ = 0;
};

/// The column of a shared text.
template <class Row>
Column<Row> column(std::string name, std::string unit, std::string description, SharedText Row::*member) {
  return {{std::move(name), std::move(unit), std::move(description), ValueType::text},
          [member](const Row& row) { return Value((row.*member).str()); },
          [member](Row& row, const Value& value) { row.*member = std::get<std::string>(value); },
          {},
          [member](std::span<Row> rows, const StoredEntries& entries) {
            SharedTextFinder shared;
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*member = shared(entries.text(i));
          }};
}

/// The column of a data member, or of a member of a member.
template <class Row, class T>
Column<Row> column(std::string name, std::string unit, std::string description, T Row::*member) {
  return {{std::move(name), std::move(unit), std::move(description), value_type<T>()},
          [member](const Row& row) { return Value(row.*member); },
          [member](Row& row, const Value& value) { row.*member = std::get<T>(value); },
          {},
          setter_of_all<Row, T>([member](Row& row) -> T& { return row.*member; })};
}

template <class Row, class Part, class T>
Column<Row> column(std::string name, std::string unit, std::string description, Part Row::*part,
                   T Part::*member) {
  return {{std::move(name), std::move(unit), std::move(description), value_type<T>()},
          [part, member](const Row& row) { return Value(row.*part.*member); },
          [part, member](Row& row, const Value& value) { row.*part.*member = std::get<T>(value); },
          {},
          setter_of_all<Row, T>([part, member](Row& row) -> T& { return row.*part.*member; })};
}

/// The column of a member of few values, each of which has a word.
template <class Row, class T>
Column<Row> column_of_words(std::string name, std::string description, T Row::*member,
                            T (*value_of)(std::string_view word)) {
  return {{std::move(name), "", std::move(description), ValueType::text},
          [member](const Row& row) { return Value(std::string(to_string(row.*member))); },
          [member, value_of](Row& row, const Value& value) {
            row.*member = value_of(std::get<std::string>(value));
          },
          {},
          [member, value_of](std::span<Row> rows, const StoredEntries& entries) {
            std::string before;
            T value{};
            for (std::size_t i = 0; i < rows.size(); ++i) {
              const std::string_view word = entries.text(i);
              if (i == 0 || word != before) value = value_of(before = word);
              rows[i].*member = value;
            }
          }};
}

/// A column that files of earlier releases lack: `absent` stands for its entries there.
template <class Row>
Column<Row> later(Column<Row> column, Value absent) {
  column.absent = std::move(absent);
  return column;
}

}  // namespace raygauge
