// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <string>
#include <vector>

#include "results/merge/row_layout.h"

namespace raygauge {

/// Writes a column of a file a chunk at a time, packed here: HDF5 serves one thread at a time. A chunk that
/// is the same as the one before is packed once.
class ColumnWriter {
 public:
  /// With HDF5 to itself, as store(). All texts are known by then.
  ColumnWriter(H5::Group& group, const RowLayout::Field& field, hsize_t rows, const TextCodes& texts);

  /// Packs a column of a RowBlock.
  void encode(const std::vector<char>& entries);

  /// Writes what was packed as the chunk that begins at row `first`.
  void store(hsize_t first);

 private:
  const RowLayout::Field& field_;
  const TextCodes& texts_;
  H5::DataSet dataset_;
  hsize_t chunk_rows_ = 0;
  std::size_t bytes_ = 0;    ///< of an entry in memory
  std::vector<char> known_;  ///< the entries packed last
  std::vector<char> chunk_;  ///< as they are in the file
  std::vector<char> packed_;
};

}  // namespace raygauge
