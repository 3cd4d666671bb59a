// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "results/merge/row_layout.h"

namespace raygauge {

/// Some rows, by columns: the entries of a field one after another, of texts their codes.
class RowBlock {
 public:
  explicit RowBlock(const RowLayout& layout);

  void resize(std::size_t rows);
  std::size_t rows() const noexcept { return rows_; }
  std::vector<char>& column(std::size_t field) { return columns_[field]; }

  /// From `rows`, and to them. On several threads.
  void gather(const std::vector<char>& rows);
  void scatter(std::vector<char>& rows) const;

 private:
  const RowLayout& layout_;
  std::size_t rows_ = 0;
  std::vector<std::vector<char>> columns_;  ///< by field
};

}  // namespace raygauge
