// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/column_writer.h"

#include <algorithm>
#include <cstring>

#include "results/exceptions.h"
#include "results/hdf5/packed_chunk.h"
#include "results/schema/column_io.h"

namespace raygauge {
namespace {

bool is_text(const RowLayout::Field& field) { return field.column->type == ValueType::text; }

}  // namespace

ColumnWriter::ColumnWriter(H5::Group& group, const RowLayout::Field& field, hsize_t rows,
                           const TextCodes& texts)
    : field_(field), texts_(texts) {
  const std::size_t length = is_text(field) ? std::max<std::size_t>(texts.longest(), 1) : 0;
  dataset_ = hdf5::create_column(group, *field.column, rows, length, hdf5::Layout::packed);
  bytes_ = hdf5::entry_bytes(field.column->type, length);
  if (rows > 0) dataset_.getCreatePlist().getChunk(1, &chunk_rows_);
}

void ColumnWriter::encode(const std::vector<char>& entries) {
  if (entries == known_) return;
  known_ = entries;
  chunk_.assign(chunk_rows_ * bytes_, '\0');
  if (!is_text(field_)) {
    std::memcpy(chunk_.data(), entries.data(), entries.size());
  } else {
    for (std::size_t i = 0; i < entries.size() / sizeof(std::uint32_t); ++i) {
      std::uint32_t code = 0;
      std::memcpy(&code, &entries[i * sizeof code], sizeof code);
      const std::string& text = texts_.text(code);
      std::memcpy(&chunk_[i * bytes_], text.data(), text.size());
    }
  }
  hdf5::pack_chunk(chunk_, bytes_, is_text(field_) ? hdf5::Packing::texts : hdf5::Packing::numbers, packed_);
}

void ColumnWriter::store(hsize_t first) {
  if (H5Dwrite_chunk(dataset_.getId(), H5P_DEFAULT, 0, &first, packed_.size(), packed_.data()) < 0) {
    throw ResultsError("a chunk of " + field_.column->name + " could not be written");
  }
}

}  // namespace raygauge
