// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <cstdint>
#include <string>
#include <vector>

#include "results/exceptions.h"
#include "results/schema/column.h"

namespace raygauge::hdf5 {

/// How columns lie in the file: `packed` in compressed, checksummed chunks, `plain` contiguous (for files of
/// a few rows, where a chunk's index would outweigh its data).
enum class Layout : std::uint8_t { plain, packed };

/// The bytes of an entry in memory, of a text as it is padded to `text_length`; and their HDF5 type.
std::size_t entry_bytes(ValueType type, std::size_t text_length);
H5::DataType entry_type(ValueType type, std::size_t text_length);

/// A one-dimensional dataset of `rows` entries that are still to be written, with the attributes `unit` and
/// `description`.
H5::DataSet create_column(H5::Group& group, const ColumnInfo& info, hsize_t rows, std::size_t text_length,
                          Layout layout);

/// A column of create_column. Throws like read_column.
H5::DataSet open_column(const H5::Group& group, const ColumnInfo& info, const std::string& place);

/// Writes a one-dimensional dataset with the attributes `unit` and `description`.
void write_column(H5::Group& group, const ColumnInfo& info, const std::vector<Value>& values, Layout layout);

/// Rows of a chunk that pack_chunk() would make of it; 0 for another layout.
hsize_t rows_of_packed_chunk(const H5::DataSet& dataset);

/// A subgroup. Throws ResultsError("PLACE/NAME: missing").
H5::Group open_group(const H5::Group& parent, const std::string& name, const std::string& place);

/// A text stored as a scalar dataset of fixed length, in UTF-8.
void write_text(H5::Group& group, const std::string& name, const std::string& text);
std::string read_text(const H5::Group& group, const std::string& name, const std::string& place);

/// Scalar attributes: text of variable length in UTF-8, or a 64-bit integer.
void write_attribute(H5::H5Object& object, const std::string& name, const std::string& text);
void write_attribute(H5::H5Object& object, const std::string& name, std::int64_t number);
std::string read_text_attribute(const H5::H5Object& object, const std::string& name,
                                const std::string& place);
std::int64_t read_integer_attribute(const H5::H5Object& object, const std::string& name,
                                    const std::string& place);

/// Writes `rows` as the group `name` of one dataset a column.
template <class Row>
void write_table(H5::Group& parent, const std::string& name, const std::vector<Column<Row>>& columns,
                 const std::vector<Row>& rows, Layout layout) {
  H5::Group group = parent.createGroup(name);
  std::vector<Value> values(rows.size());
  for (const Column<Row>& column : columns) {
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = column.get(rows[i]);
    write_column(group, column, values, layout);
  }
}

}  // namespace raygauge::hdf5
