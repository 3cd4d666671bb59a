// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/row_layout.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "results/exceptions.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace {

constexpr std::array<std::string_view, 9> kCircumstances = {"session",      "seconds", "inner_repetitions",
                                                            "load_seconds", "thread",  "concurrency",
                                                            "started_at",   "host",    "rank"};

std::size_t bytes_of(ValueType type) {
  constexpr std::array<std::size_t, 6> kBytes = {1, 4, 8, 8, 8, sizeof(std::uint32_t)};
  return kBytes[static_cast<std::size_t>(type)];
}

}  // namespace

std::uint32_t TextCodes::code(std::string_view text) {
  const auto found = codes_.find(text);
  if (found != codes_.end()) return found->second;
  const auto added = codes_.emplace(std::string(text), static_cast<std::uint32_t>(texts_.size())).first;
  texts_.push_back(&added->first);
  longest_ = std::max(longest_, text.size());
  return added->second;
}

RowLayout::RowLayout() {
  for (const Column<Record>& column : record_columns()) {
    const bool circumstance =
        std::find(kCircumstances.begin(), kCircumstances.end(), column.name) != kCircumstances.end();
    fields_.push_back({&column, row_bytes_, bytes_of(column.type), circumstance});
    row_bytes_ += fields_.back().bytes;
  }
  texts_.resize(fields_.size());
}

const RowLayout::Field& RowLayout::field(std::string_view name) const {
  for (const Field& field : fields_) {
    if (field.column->name == name) return field;
  }
  throw ResultsError("no column " + std::string(name));
}

void RowLayout::encode(const Record& record, std::span<char> row) {
  for (const Field& field : fields_) {
    const auto store = [&]<class T>(const T& value) {
      if constexpr (std::is_same_v<T, std::string>) {
        const std::uint32_t code = texts(field).code(value);
        std::memcpy(&row[field.offset], &code, sizeof code);
      } else {
        std::memcpy(&row[field.offset], &value, field.bytes);
      }
    };
    std::visit(store, field.column->get(record));
  }
}

}  // namespace raygauge
