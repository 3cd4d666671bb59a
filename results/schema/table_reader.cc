// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/table_reader.h"

namespace raygauge::hdf5 {

Value value_at(ValueType type, const StoredEntries& entries, std::size_t i) {
  switch (type) {
    case ValueType::boolean:
      return entries.truth(i);
    case ValueType::int32:
      return entries.number<std::int32_t>(i);
    case ValueType::int64:
      return entries.number<std::int64_t>(i);
    case ValueType::uint64:
      return entries.number<std::uint64_t>(i);
    case ValueType::float64:
      return entries.number<double>(i);
    case ValueType::text:
      return std::string(entries.text(i));
  }
  throw ResultsError("column of unknown type");
}

std::unique_ptr<StoredColumn> stored_column(const H5::Group& group, const ColumnInfo& info,
                                            bool may_be_absent, const std::string& place) {
  if (may_be_absent && !group.nameExists(info.name)) return nullptr;
  return std::make_unique<StoredColumn>(group, info, place);
}

}  // namespace raygauge::hdf5
