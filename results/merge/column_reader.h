// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <string>
#include <vector>

#include "results/merge/row_layout.h"

namespace raygauge {

/// Reads a column of one file after another, a chunk at a time, as a column of a RowBlock. HDF5, which serves
/// one thread at a time, only fetches the bytes; they are unpacked here. A chunk that is the same as the one
/// before, even of another file, is unpacked once.
class ColumnReader {
 public:
  ColumnReader(const RowLayout::Field& field, TextCodes& texts) : field_(field), texts_(texts) {}

  /// With HDF5 to itself. Throws ResultsError.
  void open(const H5::Group& group, const std::string& place);
  hsize_t rows() const { return rows_; }

  /// Fetches entries first, …, first + count - 1, of which the first begins a chunk. With HDF5 to itself.
  void fetch(hsize_t first, hsize_t count);

  /// Gives what was fetched. Throws ResultsError where it is damaged.
  void decode(std::vector<char>& entries);

 private:
  bool text() const { return field_.column->type == ValueType::text; }
  void unpack();

  const RowLayout::Field& field_;
  TextCodes& texts_;
  std::string place_;
  H5::DataSet dataset_;
  H5::DataType type_;      ///< of an entry in memory
  std::size_t bytes_ = 0;  ///< of an entry in memory
  hsize_t rows_ = 0;
  hsize_t chunk_rows_ = 0;  ///< 0: chunks, if any, are not as ours; HDF5 unpacks them

  hsize_t count_ = 0;           ///< entries fetched
  std::vector<char> packed_;    ///< the chunk fetched, if packed
  std::vector<char> unpacked_;  ///< the same, or what HDF5 has unpacked

  std::vector<char> known_;          ///< the packed chunk that was unpacked last
  std::size_t known_bytes_ = 0;      ///< of its entries
  std::vector<char> known_entries_;  ///< what decode() gave for it
};

}  // namespace raygauge
