// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/stored_column.h"

#include <algorithm>
#include <utility>

#include "results/exceptions.h"
#include "results/hdf5/packed_chunk.h"
#include "results/schema/column_io.h"

namespace raygauge::hdf5 {

StoredColumn::StoredColumn(const H5::Group& group, const ColumnInfo& info, const std::string& place)
    : place_(place + "/" + info.name) {
  const H5::DataSet dataset = open_column(group, info, place);
  const bool text = info.type == ValueType::text;
  rows_ = static_cast<std::size_t>(dataset.getSpace().getSimpleExtentNpoints());
  const H5::DataType type = entry_type(info.type, text ? dataset.getStrType().getSize() : 0);
  bytes_ = type.getSize();
  const bool same_bytes = text || H5Tequal(dataset.getDataType().getId(), type.getId()) > 0;
  chunk_rows_ = same_bytes ? rows_of_packed_chunk(dataset) : 0;
  if (rows_ > 0) fetch(dataset, type);
}

void StoredColumn::fetch(const H5::DataSet& dataset, const H5::DataType& type) {
  for (hsize_t first = 0; chunk_rows_ > 0 && first < rows_; first += chunk_rows_) {
    hsize_t bytes = 0;
    std::uint32_t mask = 0;
    std::vector<char> packed;
    if (H5Dget_chunk_storage_size(dataset.getId(), &first, &bytes) >= 0) packed.resize(bytes);
    const bool read =
        !packed.empty() && H5Dread_chunk(dataset.getId(), H5P_DEFAULT, &first, &mask, packed.data()) >= 0;
    if (!read || mask != 0) {
      chunk_rows_ = 0;
      break;
    }
    packed_.push_back(std::move(packed));
  }
  if (chunk_rows_ > 0) return;
  packed_.clear();
  std::vector<char> all(rows_ * bytes_);
  dataset.read(all.data(), type);
  all_ = std::make_shared<const std::vector<char>>(std::move(all));
}

std::shared_ptr<const std::vector<char>> StoredColumn::known(std::size_t chunk) {
  const std::scoped_lock lock(mutex_);
  const auto same = std::ranges::find_if(
      recent_, [&](const Unpacked& other) { return packed_[other.chunk] == packed_[chunk]; });
  return same == recent_.end() ? nullptr : same->entries;
}

std::shared_ptr<const std::vector<char>> StoredColumn::unpacked(std::size_t chunk) {
  // Of five methods in turn there are five different chunks; numbers that are not constant do not come again.
  constexpr std::size_t kKept = 16;
  constexpr std::size_t kPackedWell = 50;
  if (auto entries = known(chunk)) return entries;
  std::vector<char> bytes(chunk_rows_ * bytes_);
  if (!unpack_chunk(packed_[chunk], bytes_, bytes))
    throw ResultsError(place_ + ": truncated or damaged: a chunk cannot be unpacked");
  auto entries = std::make_shared<const std::vector<char>>(std::move(bytes));
  if (packed_[chunk].size() * kPackedWell > entries->size()) return entries;
  const std::scoped_lock lock(mutex_);
  recent_.push_front({chunk, entries});
  if (recent_.size() > kKept) recent_.pop_back();
  return entries;
}

StoredColumn::Part StoredColumn::part(std::size_t first, std::size_t count) {
  const auto from = [&](auto owner, std::size_t begin) {
    return Part{{owner->data() + begin * bytes_, bytes_, count}, owner};
  };
  if (chunk_rows_ == 0) return from(all_, first);
  const std::size_t last = first + count - 1;
  if (first / chunk_rows_ == last / chunk_rows_)
    return from(unpacked(first / chunk_rows_), first % chunk_rows_);
  auto gathered = std::make_shared<std::vector<char>>();
  for (std::size_t row = first; row <= last;) {
    const std::size_t begin = row % chunk_rows_;
    const std::size_t end = std::min(chunk_rows_, begin + last + 1 - row);
    const auto chunk = unpacked(row / chunk_rows_);
    gathered->insert(gathered->end(), chunk->data() + begin * bytes_, chunk->data() + end * bytes_);
    row += end - begin;
  }
  return from(std::shared_ptr<const std::vector<char>>(gathered), 0);
}

}  // namespace raygauge::hdf5
