// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/row_block.h"

#include <algorithm>
#include <cstring>

#include "results/hdf5/for_all.h"

namespace raygauge {
namespace {

/// Rows that a thread takes at once: they stay in its second-level cache.
constexpr std::size_t kStrip = 2048;

template <std::size_t bytes>
void copy_entries(const char* from, std::size_t from_step, char* to, std::size_t to_step, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i, from += from_step, to += to_step) std::memcpy(to, from, bytes);
}

void copy_entries(std::size_t bytes, const char* from, std::size_t from_step, char* to, std::size_t to_step,
                  std::size_t count) {
  if (bytes == 1) copy_entries<1>(from, from_step, to, to_step, count);
  if (bytes == 4) copy_entries<4>(from, from_step, to, to_step, count);
  if (bytes == 8) copy_entries<8>(from, from_step, to, to_step, count);
}

std::size_t strips(std::size_t rows) { return (rows + kStrip - 1) / kStrip; }

}  // namespace

RowBlock::RowBlock(const RowLayout& layout) : layout_(layout), columns_(layout.fields().size()) {}

void RowBlock::resize(std::size_t rows) {
  rows_ = rows;
  for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].resize(rows * layout_.fields()[i].bytes);
}

void RowBlock::gather(const std::vector<char>& rows) {
  const std::size_t width = layout_.row_bytes();
  resize(rows.size() / width);
  for_all(strips(rows_), [&](std::size_t strip) {
    const std::size_t first = strip * kStrip;
    const std::size_t count = std::min(kStrip, rows_ - first);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const RowLayout::Field& field = layout_.fields()[i];
      copy_entries(field.bytes, &rows[first * width + field.offset], width, &columns_[i][first * field.bytes],
                   field.bytes, count);
    }
  });
}

void RowBlock::scatter(std::vector<char>& rows) const {
  const std::size_t width = layout_.row_bytes();
  rows.resize(rows_ * width);
  for_all(strips(rows_), [&](std::size_t strip) {
    const std::size_t first = strip * kStrip;
    const std::size_t count = std::min(kStrip, rows_ - first);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const RowLayout::Field& field = layout_.fields()[i];
      copy_entries(field.bytes, &columns_[i][first * field.bytes], field.bytes,
                   &rows[first * width + field.offset], width, count);
    }
  });
}

}  // namespace raygauge
