// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/schema/column.h"

namespace raygauge {

/// The distinct texts of a column, numbered.
class TextCodes {
 public:
  std::uint32_t code(std::string_view text);
  const std::string& text(std::uint32_t code) const { return *texts_[code]; }
  std::size_t longest() const noexcept { return longest_; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> codes_;
  std::vector<const std::string*> texts_;
  std::size_t longest_ = 0;
};

/// A record as a row of bytes, its texts as codes.
class RowLayout {
 public:
  struct Field {
    const Column<Record>* column;
    std::size_t offset;
    std::size_t bytes;
    bool circumstance;  ///< a time, or where the record came about: differs between two solves of an instance
  };

  RowLayout();

  const std::vector<Field>& fields() const noexcept { return fields_; }
  const Field& field(std::string_view name) const;
  std::size_t row_bytes() const noexcept { return row_bytes_; }
  TextCodes& texts(const Field& field) { return texts_[static_cast<std::size_t>(&field - fields_.data())]; }

  void encode(const Record& record, std::span<char> row);

 private:
  std::vector<Field> fields_;
  std::vector<TextCodes> texts_;  ///< by field
  std::size_t row_bytes_ = 0;
};

/// An entry of a row.
template <class T>
T entry_of(const char* row, const RowLayout::Field& field) {
  T value;
  std::memcpy(&value, row + field.offset, sizeof value);
  return value;
}

}  // namespace raygauge
