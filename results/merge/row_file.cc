// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/row_file.h"

#include <H5Cpp.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "results/disk/atomic_file.h"
#include "results/hdf5/checksum.h"
#include "results/hdf5/for_all.h"
#include "results/hdf5/hdf5_library.h"
#include "results/merge/column_writer.h"
#include "results/run/encoding.h"
#include "results/schema/column_io.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

void raise_sessions(std::vector<char>& rows, int by, const RowLayout& layout) {
  const RowLayout::Field& field = layout.field("session");
  for (std::size_t at = 0; at < rows.size(); at += layout.row_bytes()) {
    const int session = entry_of<std::int32_t>(&rows[at], field) + by;
    std::memcpy(&rows[at + field.offset], &session, sizeof session);
  }
}

/// Takes rows in their order and writes them to the columns of a file, a chunk at a time.
class RowWriter {
 public:
  RowWriter(H5::Group& records, hsize_t total, RowLayout& layout) : layout_(layout), block_(layout) {
    columns_.reserve(layout.fields().size());
    for (const RowLayout::Field& field : layout.fields()) {
      columns_.emplace_back(records, field, total, layout.texts(field));
    }
    rows_.resize(kRowsAtOnce * layout.row_bytes());
  }

  void add(const RowRun& run, const RowSpool& spool) {
    for (std::uint32_t done = 0; done < run.rows;) {
      const auto count =
          static_cast<std::uint32_t>(std::min<std::size_t>(run.rows - done, kRowsAtOnce - held_));
      spool.read(run.row + done, count, &rows_[held_ * layout_.row_bytes()]);
      done += count;
      held_ += count;
      if (held_ == kRowsAtOnce) flush();
    }
  }

  void flush() {
    if (held_ == 0) return;
    rows_.resize(held_ * layout_.row_bytes());
    block_.gather(rows_);
    for_all(columns_.size(), [this](std::size_t i) { columns_[i].encode(block_.column(i)); });
    for (ColumnWriter& column : columns_) column.store(written_);
    written_ += held_;
    held_ = 0;
    rows_.resize(kRowsAtOnce * layout_.row_bytes());
  }

 private:
  RowLayout& layout_;
  std::vector<ColumnWriter> columns_;
  RowBlock block_;
  std::vector<char> rows_;
  std::size_t held_ = 0;  ///< rows that wait to be written
  hsize_t written_ = 0;
};

}  // namespace

RowReader::RowReader(RowSpool& spool) : spool_(spool), block_(spool.layout()) {
  RowLayout& layout = spool.layout();
  columns_.reserve(layout.fields().size());
  for (const RowLayout::Field& field : layout.fields()) columns_.emplace_back(field, layout.texts(field));
}

void RowReader::add_file(const fs::path& path, std::uint32_t part, int first_session) {
  hdf5::read_file(path, [&](H5::Group& root) {
    const H5::Group records = hdf5::open_group(root, "records", path.string() + ": ");
    const std::string place = path.string() + ": /records";
    for (ColumnReader& column : columns_) {
      column.open(records, place);
      if (column.rows() == columns_.front().rows()) continue;
      throw ResultsError(place + ": columns of different lengths");
    }
    const hsize_t total = columns_.front().rows();
    for (hsize_t first = 0; first < total; first += kRowsAtOnce) {
      read_block(first, std::min<hsize_t>(kRowsAtOnce, total - first));
      raise_sessions(rows_, first_session, spool_.layout());
      spool_.append(part, rows_);
    }
  });
}

void RowReader::read_block(hsize_t first, hsize_t count) {
  block_.resize(count);
  for (ColumnReader& column : columns_) column.fetch(first, count);
  for_all(columns_.size(), [this](std::size_t i) { columns_[i].decode(block_.column(i)); });
  block_.scatter(rows_);
}

void RowReader::add_records(const std::vector<Record>& records, std::uint32_t part, int first_session) {
  RowLayout& layout = spool_.layout();
  std::vector<char> rows(records.size() * layout.row_bytes());
  for (std::size_t i = 0; i < records.size(); ++i) {
    layout.encode(records[i], std::span(rows).subspan(i * layout.row_bytes(), layout.row_bytes()));
  }
  raise_sessions(rows, first_session, layout);
  spool_.append(part, rows);
}

void write_rows(const fs::path& path, const Provenance& provenance, const std::vector<RowRun>& runs,
                RowSpool& spool) {
  const fs::path temporary = path.string() + "." + std::to_string(::getpid()) + ".tmp";
  try {
    hdf5::locked(path.string(), "HDF5 could not write it", [&] {
      H5::H5File file(temporary.string(), H5F_ACC_TRUNC);
      H5::Group root = file.openGroup("/");
      write_description(root, provenance);
      H5::Group records = root.createGroup("records");
      hsize_t total = 0;
      for (const RowRun& run : runs) total += run.rows;
      RowWriter writer(records, total, spool.layout());
      for (const RowRun& run : runs) writer.add(run, spool);
      writer.flush();
    });
    hdf5::append_checksum(temporary);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  move_durably(temporary, path);
}

}  // namespace raygauge
