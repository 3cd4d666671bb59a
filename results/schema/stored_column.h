// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "results/schema/column.h"

namespace raygauge::hdf5 {

/// A column of a file, as it lies there. HDF5, which serves one thread at a time, has only fetched the bytes;
/// chunks are unpacked when their rows are asked for, on any thread. Chunks that are the same are unpacked
/// once: of a constant column, all of them.
class StoredColumn {
 public:
  /// With HDF5 to itself. `place` names the group in messages: "x.h5: /records". Throws ResultsError for a
  /// dataset that is missing or of another type or rank.
  StoredColumn(const H5::Group& group, const ColumnInfo& info, const std::string& place);

  std::size_t rows() const noexcept { return rows_; }

  /// Rows of a chunk; 0 where chunks, if any, are not as ours: then HDF5 has unpacked them.
  std::size_t chunk_rows() const noexcept { return chunk_rows_; }

  /// Entries, and who owns them.
  struct Part {
    StoredEntries entries;
    std::shared_ptr<const std::vector<char>> owner;
  };

  /// The entries first, …, first + count - 1. Throws ResultsError for a chunk that is damaged.
  Part part(std::size_t first, std::size_t count);

 private:
  struct Unpacked {
    std::size_t chunk;
    std::shared_ptr<const std::vector<char>> entries;
  };

  void fetch(const H5::DataSet& dataset, const H5::DataType& type);
  std::shared_ptr<const std::vector<char>> known(std::size_t chunk);
  std::shared_ptr<const std::vector<char>> unpacked(std::size_t chunk);

  std::string place_;
  std::size_t rows_ = 0;
  std::size_t bytes_ = 0;  ///< of an entry
  std::size_t chunk_rows_ = 0;
  std::vector<std::vector<char>> packed_;         ///< by chunk
  std::shared_ptr<const std::vector<char>> all_;  ///< without chunks
  std::mutex mutex_;
  std::deque<Unpacked> recent_;  ///< chunks that may come again
};

}  // namespace raygauge::hdf5
