// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/exceptions.h"
#include "results/hdf5/for_all.h"
#include "results/schema/column.h"
#include "results/schema/column_io.h"
#include "results/schema/stored_column.h"

namespace raygauge::hdf5 {

/// The entry as a Value.
Value value_at(ValueType type, const StoredEntries& entries, std::size_t i);

/// The column; nothing where the file may lack it and does. Throws like StoredColumn().
std::unique_ptr<StoredColumn> stored_column(const H5::Group& group, const ColumnInfo& info,
                                            bool may_be_absent, const std::string& place);

/// A table of a file whose bytes have been fetched: what is left to do needs no HDF5.
template <class Row>
class StoredTable {
 public:
  StoredTable() = default;

  /// With HDF5 to itself. A column that the file lacks has its documented default in every row (the first
  /// column is in every file). Throws ResultsError, also for columns of different lengths.
  StoredTable(const H5::Group& parent, const std::string& name, const std::vector<Column<Row>>& columns,
              const std::string& place)
      : columns_(&columns), place_(place + "/" + name) {
    const H5::Group group = open_group(parent, name, place);
    for (const Column<Row>& column : columns) {
      stored_.push_back(stored_column(group, column, column.absent.has_value(), place_));
      const StoredColumn* last = stored_.back().get();
      if (last == nullptr || last->rows() == size()) continue;
      throw ResultsError(place_ + "/" + column.name + ": " + std::to_string(last->rows()) + " entries, but " +
                         columns.front().name + " has " + std::to_string(size()));
    }
  }

  std::size_t size() const noexcept { return stored_.empty() ? 0 : stored_.front()->rows(); }

  /// Throws ResultsError for damaged bytes and for values that a column cannot have.
  std::vector<Row> rows() const {
    std::vector<Row> rows(size());
    fill(rows, 0);
    return rows;
  }

  /// The same on several threads.
  std::vector<Row> rows_by_threads() const {
    std::vector<Row> rows(size());
    const std::size_t at_once = chunk_rows();
    for_all((rows.size() + at_once - 1) / at_once, [&](std::size_t i) {
      const std::size_t first = i * at_once;
      fill(std::span(rows).subspan(first, std::min(at_once, rows.size() - first)), first);
    });
    return rows;
  }

 private:
  static constexpr std::size_t kStrip = 1024;  ///< rows that stay in a thread's cache for all columns

  /// Of the columns, the most; at least 1.
  std::size_t chunk_rows() const {
    std::size_t most = 1;
    for (const auto& column : stored_) {
      if (column) most = std::max(most, column->chunk_rows() > 0 ? column->chunk_rows() : size());
    }
    return most;
  }

  /// `rows` are the rows first, … of the table.
  void fill(std::span<Row> rows, std::size_t first) const {
    if (rows.empty()) return;
    std::vector<StoredColumn::Part> parts;
    for (const auto& column : stored_)
      parts.push_back(column ? column->part(first, rows.size()) : StoredColumn::Part());
    for (std::size_t begin = 0; begin < rows.size(); begin += kStrip) {
      const std::span<Row> strip = rows.subspan(begin, std::min(kStrip, rows.size() - begin));
      for (std::size_t c = 0; c < stored_.size(); ++c) {
        StoredEntries entries = parts[c].entries;
        entries.bytes += begin * entries.width;
        set((*columns_)[c], stored_[c] ? &entries : nullptr, strip);
      }
    }
  }

  void set(const Column<Row>& column, const StoredEntries* entries, std::span<Row> rows) const {
    try {
      if (entries != nullptr && column.set_all) return column.set_all(rows, *entries);
      for (std::size_t i = 0; i < rows.size(); ++i)
        column.set(rows[i], entries == nullptr ? *column.absent : value_at(column.type, *entries, i));
    } catch (const Error& error) {
      throw ResultsError(place_ + "/" + column.name + ": " + error.what());
    }
  }

  const std::vector<Column<Row>>* columns_ = nullptr;
  std::string place_;
  std::vector<std::unique_ptr<StoredColumn>> stored_;
};

/// The inverse of write_table. With HDF5 to itself. Throws like StoredTable.
template <class Row>
std::vector<Row> read_table(const H5::Group& parent, const std::string& name,
                            const std::vector<Column<Row>>& columns, const std::string& place) {
  return StoredTable<Row>(parent, name, columns, place).rows();
}

}  // namespace raygauge::hdf5
