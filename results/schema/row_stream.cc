// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/row_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <future>
#include <memory>
#include <utility>

#include "raygauge/exceptions.h"
#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/schema/open_dataset.h"

namespace raygauge {
namespace {

constexpr std::size_t kPartBytes = std::size_t{1} << 24;

// A file that is closed whatever happens.
class OpenFile {
 public:
  explicit OpenFile(const StoredRows& rows) : descriptor_(::open(rows.file.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw ResultsError(rows.place + ": " + std::strerror(errno));
    ::posix_fadvise(descriptor_, static_cast<off_t>(rows.offset), 0, POSIX_FADV_SEQUENTIAL);
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

// As `numbers` of `size` bytes, one after the other.
bool is_plain(const H5::DataSet& dataset, hsize_t numbers, std::size_t size) {
  const H5::DSetCreatPropList list = dataset.getCreatePlist();
  return list.getLayout() == H5D_CONTIGUOUS && list.getExternalCount() == 0 &&
         dataset.getStorageSize() == numbers * size;
}

}  // namespace

std::optional<StoredRows> find_stored_rows(const DatasetReference& reference) {
  StoredRows found;
  found.place = reference.file + ":" + reference.dataset;
  found.file = reference.file;
  bool plain = false;
  hdf5::read_file(reference.file, [&](H5::Group& root) {
    const H5::DataSet dataset = open_numeric(root, reference.dataset, found.place);
    const H5::DataSpace space = dataset.getSpace();
    if (space.getSimpleExtentNdims() != 2) return;
    std::array<hsize_t, 2> extent{};
    space.getSimpleExtentDims(extent.data());
    const H5::DataType type = dataset.getDataType();
    found.single = type == H5::PredType::NATIVE_FLOAT;
    if (!found.single && !(type == H5::PredType::NATIVE_DOUBLE)) return;
    const std::size_t size = found.single ? sizeof(float) : sizeof(double);
    if (extent[0] == 0 || extent[1] == 0 || !is_plain(dataset, extent[0] * extent[1], size)) return;
    found.rows = static_cast<std::ptrdiff_t>(extent[0]);
    found.columns = static_cast<int>(extent[1]);
    found.offset = dataset.getOffset();
    plain = true;
  });
  if (!plain) return std::nullopt;
  return found;
}

RowStream::RowStream(StoredRows rows) : rows_(std::move(rows)) {
  const std::size_t row =
      static_cast<std::size_t>(rows_.columns) * (rows_.single ? sizeof(float) : sizeof(double));
  together_ = std::min(rows_.rows, static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, kPartBytes / row)));
  for (auto& buffer : buffer_)
    buffer.resize((static_cast<std::size_t>(together_) * row + sizeof(double) - 1) / sizeof(double));
}

StreamedPoints RowStream::part(std::ptrdiff_t first, std::ptrdiff_t count, int buffer) const {
  const double* data = buffer_[buffer].data();
  if (rows_.single) return {nullptr, reinterpret_cast<const float*>(data), first, count};
  return {data, nullptr, first, count};
}

// Rows from `first` on, as many as there are and fit. Returns how many.
std::ptrdiff_t RowStream::read(int file, std::ptrdiff_t first, int buffer) {
  const std::ptrdiff_t count = std::min(together_, rows_.rows - first);
  const std::size_t row =
      static_cast<std::size_t>(rows_.columns) * (rows_.single ? sizeof(float) : sizeof(double));
  auto left = static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)) * row;
  auto* to = reinterpret_cast<char*>(buffer_[buffer].data());
  auto at = static_cast<off_t>(rows_.offset + static_cast<std::uint64_t>(first) * row);
  while (left > 0) {
    const ssize_t got = ::pread(file, to, left, at);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0)
      throw ResultsError(rows_.place + ": " + (got < 0 ? std::strerror(errno) : "the file is truncated"));
    to += got;
    at += got;
    left -= static_cast<std::size_t>(got);
  }
  return std::max<std::ptrdiff_t>(count, 0);
}

void RowStream::pass(const std::function<bool(const StreamedPoints&)>& visit) {
  const OpenFile file(rows_);
  std::ptrdiff_t first = 0;
  std::ptrdiff_t count = read(file.descriptor(), 0, 0);
  for (int buffer = 0; count > 0; buffer = 1 - buffer) {
    const std::ptrdiff_t next = first + count;
    std::future<std::ptrdiff_t> ahead = std::async(
        std::launch::async, [&, next, buffer] { return read(file.descriptor(), next, 1 - buffer); });
    bool more = false;
    try {
      more = visit(part(first, count, buffer));
    } catch (const NonFiniteError& error) {
      throw NonFiniteError(rows_.place + ": " + error.what());
    }
    const std::ptrdiff_t read_ahead = ahead.get();
    if (!more) return;
    first = next;
    count = read_ahead;
  }
}

}  // namespace raygauge
