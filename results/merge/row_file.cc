// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/row_file.h"

#include <H5Cpp.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "results/hdf5/hdf5_library.h"
#include "results/run/atomic_file.h"
#include "results/schema/column_io.h"
#include "results/schema/encoding.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

/// A column of a file, of which some rows at a time are read or written.
struct OpenColumn {
  H5::DataSet dataset;
  H5::DataType type;        ///< of an entry in memory
  std::size_t bytes = 0;    ///< of an entry in memory
  std::vector<char> block;  ///< entries of the rows at hand
};

H5::DataSpace rows_of(const H5::DataSet& dataset, hsize_t first, hsize_t count) {
  H5::DataSpace space = dataset.getSpace();
  space.selectHyperslab(H5S_SELECT_SET, &count, &first);
  return space;
}

/// Puts the entries of a column's block into rows.
void scatter(const OpenColumn& column, const RowLayout::Field& field, RowLayout& layout,
             std::vector<char>& rows, std::size_t count) {
  const std::size_t width = layout.row_bytes();
  std::string_view before;
  std::uint32_t code = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const char* entry = &column.block[i * column.bytes];
    char* place = &rows[i * width + field.offset];
    if (field.column->type != ValueType::text) {
      std::memcpy(place, entry, field.bytes);
      continue;
    }
    const std::string_view text(entry, ::strnlen(entry, column.bytes));
    if (i == 0 || text != before) code = layout.texts(field).code(text);
    before = text;
    std::memcpy(place, &code, sizeof code);
  }
}

/// The inverse.
void gather(const std::vector<char>& rows, std::size_t count, const RowLayout::Field& field,
            RowLayout& layout, OpenColumn& column) {
  const std::size_t width = layout.row_bytes();
  if (field.column->type == ValueType::text) std::fill(column.block.begin(), column.block.end(), '\0');
  for (std::size_t i = 0; i < count; ++i) {
    const char* place = &rows[i * width + field.offset];
    char* entry = &column.block[i * column.bytes];
    if (field.column->type != ValueType::text) {
      std::memcpy(entry, place, field.bytes);
      continue;
    }
    std::uint32_t code = 0;
    std::memcpy(&code, place, sizeof code);
    const std::string& text = layout.texts(field).text(code);
    std::memcpy(entry, text.data(), text.size());
  }
}

void raise_sessions(std::vector<char>& rows, int by, const RowLayout& layout) {
  const RowLayout::Field& field = layout.field("session");
  for (std::size_t at = 0; at < rows.size(); at += layout.row_bytes()) {
    const int session = entry_of<std::int32_t>(&rows[at], field) + by;
    std::memcpy(&rows[at + field.offset], &session, sizeof session);
  }
}

OpenColumn open_for_reading(const H5::Group& group, const ColumnInfo& info, const std::string& place,
                            hsize_t rows) {
  OpenColumn column;
  column.dataset = hdf5::open_column(group, info, place);
  if (static_cast<hsize_t>(column.dataset.getSpace().getSimpleExtentNpoints()) != rows) {
    throw ResultsError(place + "/" + info.name + ": is not as long as the others");
  }
  const std::size_t text = info.type == ValueType::text ? column.dataset.getStrType().getSize() : 0;
  column.type = hdf5::entry_type(info.type, text);
  column.bytes = column.type.getSize();
  column.block.resize(column.bytes * kRowsAtOnce);
  return column;
}

void read_rows(const H5::Group& records, const std::string& place, std::uint32_t part, int first_session,
               RowSpool& spool) {
  RowLayout& layout = spool.layout();
  const auto total = static_cast<hsize_t>(
      hdf5::open_column(records, *layout.fields().front().column, place).getSpace().getSimpleExtentNpoints());
  std::vector<OpenColumn> columns;
  for (const RowLayout::Field& field : layout.fields()) {
    columns.push_back(open_for_reading(records, *field.column, place, total));
  }
  std::vector<char> rows;
  for (hsize_t first = 0; first < total; first += kRowsAtOnce) {
    const hsize_t count = std::min<hsize_t>(kRowsAtOnce, total - first);
    rows.resize(count * layout.row_bytes());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      OpenColumn& column = columns[i];
      column.dataset.read(column.block.data(), column.type, H5::DataSpace(1, &count),
                          rows_of(column.dataset, first, count));
      scatter(column, layout.fields()[i], layout, rows, count);
    }
    raise_sessions(rows, first_session, layout);
    spool.append(part, rows);
  }
}

/// Takes rows in their order and writes them to the columns of a file, a chunk at a time.
class RowWriter {
 public:
  RowWriter(H5::Group& records, hsize_t total, RowLayout& layout) : layout_(layout) {
    for (const RowLayout::Field& field : layout.fields()) {
      const bool text = field.column->type == ValueType::text;
      const std::size_t length = text ? std::max<std::size_t>(layout.texts(field).longest(), 1) : 0;
      OpenColumn column;
      column.dataset = hdf5::create_column(records, *field.column, total, length, hdf5::Layout::packed);
      column.type = hdf5::entry_type(field.column->type, length);
      column.bytes = column.type.getSize();
      column.block.resize(column.bytes * kRowsAtOnce);
      columns_.push_back(std::move(column));
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
    const hsize_t count = held_;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      OpenColumn& column = columns_[i];
      gather(rows_, held_, layout_.fields()[i], layout_, column);
      column.dataset.write(column.block.data(), column.type, H5::DataSpace(1, &count),
                           rows_of(column.dataset, written_, count));
    }
    written_ += held_;
    held_ = 0;
  }

 private:
  RowLayout& layout_;
  std::vector<OpenColumn> columns_;
  std::vector<char> rows_;
  std::size_t held_ = 0;  ///< rows that wait to be written
  hsize_t written_ = 0;
};

}  // namespace

void spool_file(const fs::path& path, std::uint32_t part, int first_session, RowSpool& spool) {
  hdf5::read_file(path, [&](H5::Group& root) {
    const H5::Group records = hdf5::open_group(root, "records", path.string() + ": ");
    read_rows(records, path.string() + ": /records", part, first_session, spool);
  });
}

void spool_records(const std::vector<Record>& records, std::uint32_t part, int first_session,
                   RowSpool& spool) {
  RowLayout& layout = spool.layout();
  std::vector<char> rows(records.size() * layout.row_bytes());
  for (std::size_t i = 0; i < records.size(); ++i) {
    layout.encode(records[i], std::span(rows).subspan(i * layout.row_bytes(), layout.row_bytes()));
  }
  raise_sessions(rows, first_session, layout);
  spool.append(part, rows);
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
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  move_durably(temporary, path);
}

}  // namespace raygauge
