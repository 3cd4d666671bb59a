// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/queries/point_stream.h"
#include "results/schema/dataset.h"

namespace raygauge {

/// Where a file holds the rows of a dataset as they are in memory: one after the other, neither compressed
/// nor in chunks, in this machine's single or double precision.
struct StoredRows {
  std::string place;  ///< for messages
  std::string file;
  std::uint64_t offset = 0;  ///< bytes
  std::ptrdiff_t rows = 0;
  int columns = 0;
  bool single = false;
};

/// Nothing where the dataset is stored otherwise. Throws ResultsError as read_points does.
std::optional<StoredRows> find_stored_rows(const DatasetReference& reference);

/// Rows straight from the file: one part is read while the one before is looked at. Holds 32 MiB.
class RowStream final : public PointStream {
 public:
  explicit RowStream(StoredRows rows);
  int dimension() const noexcept override { return rows_.columns; }
  std::ptrdiff_t size() const noexcept override { return rows_.rows; }

  /// Throws ResultsError where the file cannot be read, and NonFiniteError with the dataset's name before it.
  void pass(const std::function<bool(const StreamedPoints&)>& visit) override;

 private:
  std::ptrdiff_t read(int file, std::ptrdiff_t first, int buffer);
  StreamedPoints part(std::ptrdiff_t first, std::ptrdiff_t count, int buffer) const;

  StoredRows rows_;
  std::ptrdiff_t together_;  // rows of a part
  std::vector<double> buffer_[2];
};

}  // namespace raygauge
