// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/column_reader.h"

#include <cstring>
#include <string_view>

#include "results/exceptions.h"
#include "results/hdf5/packed_chunk.h"
#include "results/merge/row_file.h"
#include "results/schema/column_io.h"

namespace raygauge {

void ColumnReader::open(const H5::Group& group, const std::string& place) {
  const ColumnInfo& info = *field_.column;
  place_ = place + "/" + info.name;
  dataset_ = hdf5::open_column(group, info, place);
  rows_ = static_cast<hsize_t>(dataset_.getSpace().getSimpleExtentNpoints());
  type_ = hdf5::entry_type(info.type, text() ? dataset_.getStrType().getSize() : 0);
  bytes_ = type_.getSize();
  const bool same_bytes = text() || H5Tequal(dataset_.getDataType().getId(), type_.getId()) > 0;
  chunk_rows_ = same_bytes ? hdf5::rows_of_packed_chunk(dataset_) : 0;
}

void ColumnReader::fetch(hsize_t first, hsize_t count) {
  count_ = count;
  packed_.clear();
  hsize_t packed_bytes = 0;
  const bool whole_chunk = chunk_rows_ != 0 && count <= chunk_rows_ && first % chunk_rows_ == 0;
  if (whole_chunk && H5Dget_chunk_storage_size(dataset_.getId(), &first, &packed_bytes) >= 0) {
    packed_.resize(packed_bytes);
    std::uint32_t mask = 0;
    const bool read = H5Dread_chunk(dataset_.getId(), H5P_DEFAULT, &first, &mask, packed_.data()) >= 0;
    if (read && mask == 0) return;
    packed_.clear();
  }
  unpacked_.resize(count * bytes_);
  H5::DataSpace space = dataset_.getSpace();
  space.selectHyperslab(H5S_SELECT_SET, &count, &first);
  dataset_.read(unpacked_.data(), type_, H5::DataSpace(1, &count), space);
}

void ColumnReader::unpack() {
  unpacked_.resize(chunk_rows_ * bytes_);
  if (!hdf5::unpack_chunk(packed_, bytes_, unpacked_)) throw ResultsError(place_ + ": is damaged");
}

void ColumnReader::decode(std::vector<char>& entries) {
  if (!packed_.empty() && packed_ == known_ && bytes_ == known_bytes_ &&
      known_entries_.size() == count_ * field_.bytes) {
    entries = known_entries_;
    return;
  }
  if (!packed_.empty()) unpack();
  entries.resize(count_ * field_.bytes);
  if (!text()) {
    std::memcpy(entries.data(), unpacked_.data(), entries.size());
  } else {
    std::string_view before;
    std::uint32_t code = 0;
    for (hsize_t i = 0; i < count_; ++i) {
      const char* entry = &unpacked_[i * bytes_];
      const std::string_view text(entry, ::strnlen(entry, bytes_));
      if (i == 0 || text != before) code = texts_.code(text);
      before = text;
      std::memcpy(&entries[i * sizeof code], &code, sizeof code);
    }
  }
  known_ = packed_;
  known_bytes_ = bytes_;
  known_entries_ = entries;
}

}  // namespace raygauge
