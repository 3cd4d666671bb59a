// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/column_io.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace raygauge::hdf5 {
namespace {

constexpr hsize_t kChunkRows = 16384;
constexpr int kDeflateLevel = 1;  ///< level 4: 2 % smaller in half as much time again

/// The same type behind its base class, which the C++ layer passes by value.
H5::DataType plain(const H5::DataType& type) { return H5::DataType(type.getId()); }

/// A boolean as h5py stores one: an enumeration of FALSE and TRUE over one byte.
H5::DataType boolean_type() {
  H5::EnumType type(H5::PredType::STD_I8LE);
  std::int8_t value = 0;
  type.insert("FALSE", &value);
  value = 1;
  type.insert("TRUE", &value);
  return plain(type);
}

/// Text of at most `length` bytes. Fixed, because HDF5 cannot compress text of variable length.
H5::StrType text_type(std::size_t length) {
  H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(length, 1));
  type.setStrpad(H5T_STR_NULLPAD);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

std::size_t longest(const std::vector<Value>& values) {
  std::size_t length = 0;
  for (const Value& value : values) length = std::max(length, std::get<std::string>(value).size());
  return length;
}

std::string without_padding(std::string text) {
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

H5::DataType file_type(ValueType type, std::size_t text_length) {
  switch (type) {
    case ValueType::boolean:
      return boolean_type();
    case ValueType::int32:
      return H5::PredType::STD_I32LE;
    case ValueType::int64:
      return H5::PredType::STD_I64LE;
    case ValueType::uint64:
      return H5::PredType::STD_U64LE;
    case ValueType::float64:
      return H5::PredType::IEEE_F64LE;
    case ValueType::text:
      return plain(text_type(text_length));
  }
  throw ResultsError("column of unknown type");
}

H5T_class_t class_of(ValueType type) {
  constexpr std::array<H5T_class_t, 6> kClasses = {H5T_ENUM,    H5T_INTEGER, H5T_INTEGER,
                                                   H5T_INTEGER, H5T_FLOAT,   H5T_STRING};
  return kClasses.at(static_cast<std::size_t>(type));
}

H5::DSetCreatPropList creation_properties(hsize_t rows, Layout layout) {
  H5::DSetCreatPropList properties;
  H5Pset_obj_track_times(properties.getId(), false);  // the same content gives the same bytes
  if (layout == Layout::plain || rows == 0) return properties;
  const hsize_t chunk = std::min(rows, kChunkRows);
  properties.setChunk(1, &chunk);
  properties.setShuffle();
  properties.setDeflate(kDeflateLevel);
  properties.setFletcher32();
  return properties;
}

template <class Stored, class T>
void write_numbers(const H5::DataSet& dataset, const H5::DataType& type, const std::vector<Value>& values) {
  std::vector<Stored> buffer(values.size());
  std::transform(values.begin(), values.end(), buffer.begin(),
                 [](const Value& value) { return static_cast<Stored>(std::get<T>(value)); });
  dataset.write(buffer.data(), type);
}

void write_texts(const H5::DataSet& dataset, const H5::DataType& type, const std::vector<Value>& values) {
  const std::size_t width = type.getSize();
  std::string buffer(width * values.size(), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& text = std::get<std::string>(values[i]);
    std::copy(text.begin(), text.end(), buffer.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  dataset.write(buffer.data(), type);
}

/// A dataset of the expected class and rank, or a ResultsError that says what is there instead.
H5::DataSet open_dataset(const H5::Group& group, const ColumnInfo& info, int rank, const std::string& place) {
  const std::string here = place + "/" + info.name;
  if (!group.nameExists(info.name)) throw ResultsError(here + ": missing");
  H5::DataSet dataset = group.openDataSet(info.name);
  const bool fixed_text = info.type != ValueType::text || !dataset.getDataType().isVariableStr();
  if (dataset.getTypeClass() != class_of(info.type) || !fixed_text) {
    throw ResultsError(here + ": is not of type " + std::string(to_string(info.type)));
  }
  if (dataset.getSpace().getSimpleExtentNdims() != rank) {
    throw ResultsError(here + ": rank " + std::to_string(dataset.getSpace().getSimpleExtentNdims()) +
                       ", expected " + std::to_string(rank));
  }
  return dataset;
}

H5::Attribute open_attribute(const H5::H5Object& object, const std::string& name, H5T_class_t type_class,
                             const std::string& place) {
  if (!object.attrExists(name)) throw ResultsError(place + ": attribute " + name + " is missing");
  H5::Attribute attribute = object.openAttribute(name);
  if (attribute.getTypeClass() != type_class || attribute.getSpace().getSimpleExtentNpoints() != 1) {
    throw ResultsError(place + ": attribute " + name + " is of an unexpected type");
  }
  return attribute;
}

}  // namespace

std::size_t entry_bytes(ValueType type, std::size_t text_length) {
  return entry_type(type, text_length).getSize();
}

H5::DataType entry_type(ValueType type, std::size_t text_length) {
  return file_type(type, text_length);  // little-endian, as are the machines this runs on
}

H5::DataSet create_column(H5::Group& group, const ColumnInfo& info, hsize_t rows, std::size_t text_length,
                          Layout layout) {
  H5::DataSet dataset = group.createDataSet(info.name, file_type(info.type, text_length),
                                            H5::DataSpace(1, &rows), creation_properties(rows, layout));
  write_attribute(dataset, "unit", info.unit);
  write_attribute(dataset, "description", info.description);
  return dataset;
}

H5::DataSet open_column(const H5::Group& group, const ColumnInfo& info, const std::string& place) {
  return open_dataset(group, info, 1, place);
}

hsize_t rows_of_packed_chunk(const H5::DataSet& dataset) {
  const H5::DSetCreatPropList properties = dataset.getCreatePlist();
  constexpr std::array<H5Z_filter_t, 3> kFilters = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE,
                                                    H5Z_FILTER_FLETCHER32};
  if (properties.getLayout() != H5D_CHUNKED || properties.getNfilters() != 3) return 0;
  for (unsigned i = 0; i < kFilters.size(); ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    unsigned config = 0;
    if (H5Pget_filter2(properties.getId(), i, &flags, &values, nullptr, 0, nullptr, &config) !=
        kFilters.at(i)) {
      return 0;
    }
  }
  hsize_t rows = 0;
  properties.getChunk(1, &rows);
  return rows;
}

void write_column(H5::Group& group, const ColumnInfo& info, const std::vector<Value>& values, Layout layout) {
  const std::size_t text_length = info.type == ValueType::text ? longest(values) : 0;
  const H5::DataType type = file_type(info.type, text_length);
  const hsize_t rows = values.size();
  const H5::DataSet dataset = create_column(group, info, rows, text_length, layout);
  if (rows == 0) return;
  switch (info.type) {
    case ValueType::boolean:
      return write_numbers<std::int8_t, bool>(dataset, type, values);
    case ValueType::int32:
      return write_numbers<std::int32_t, std::int32_t>(dataset, H5::PredType::NATIVE_INT32, values);
    case ValueType::int64:
      return write_numbers<std::int64_t, std::int64_t>(dataset, H5::PredType::NATIVE_INT64, values);
    case ValueType::uint64:
      return write_numbers<std::uint64_t, std::uint64_t>(dataset, H5::PredType::NATIVE_UINT64, values);
    case ValueType::float64:
      return write_numbers<double, double>(dataset, H5::PredType::NATIVE_DOUBLE, values);
    case ValueType::text:
      return write_texts(dataset, type, values);
  }
}

H5::Group open_group(const H5::Group& parent, const std::string& name, const std::string& place) {
  if (!parent.nameExists(name)) throw ResultsError(place + "/" + name + ": missing");
  return parent.openGroup(name);
}

void write_text(H5::Group& group, const std::string& name, const std::string& text) {
  const H5::StrType type = text_type(text.size());
  group.createDataSet(name, type, H5::DataSpace(H5S_SCALAR), creation_properties(1, Layout::plain))
      .write(text, type);
}

std::string read_text(const H5::Group& group, const std::string& name, const std::string& place) {
  const ColumnInfo expected = {name, "", "", ValueType::text};
  const H5::DataSet dataset = open_dataset(group, expected, 0, place);
  std::string text(dataset.getStrType().getSize(), '\0');
  dataset.read(text.data(), text_type(text.size()));
  return without_padding(std::move(text));
}

void write_attribute(H5::H5Object& object, const std::string& name, const std::string& text) {
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  object.createAttribute(name, type, H5::DataSpace(H5S_SCALAR)).write(type, text);
}

void write_attribute(H5::H5Object& object, const std::string& name, std::int64_t number) {
  object.createAttribute(name, H5::PredType::STD_I64LE, H5::DataSpace(H5S_SCALAR))
      .write(H5::PredType::NATIVE_INT64, &number);
}

std::string read_text_attribute(const H5::H5Object& object, const std::string& name,
                                const std::string& place) {
  const H5::Attribute attribute = open_attribute(object, name, H5T_STRING, place);
  const H5::StrType type = attribute.getStrType();
  if (type.isVariableStr()) {  // not by the C++ layer, which takes a text without a place for one
    char* text = nullptr;
    attribute.read(type, static_cast<void*>(&text));
    const std::unique_ptr<char, void (*)(void*)> owned(text, [](void* memory) { H5free_memory(memory); });
    if (text == nullptr) throw ResultsError(place + ": attribute " + name + " has no text");
    return text;
  }
  std::string text(type.getSize(), '\0');
  attribute.read(type, static_cast<void*>(text.data()));
  return without_padding(text.substr(0, text.find('\0')));
}

std::int64_t read_integer_attribute(const H5::H5Object& object, const std::string& name,
                                    const std::string& place) {
  std::int64_t number = 0;
  open_attribute(object, name, H5T_INTEGER, place).read(H5::PredType::NATIVE_INT64, &number);
  return number;
}

}  // namespace raygauge::hdf5
