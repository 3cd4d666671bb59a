// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// PLY as in G. Turk, The PLY Polygon File Format (1994): a header of elements and their properties, then the
// elements one after the other.
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"

namespace raygauge::cli {
namespace {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t kNoCoordinate = 3;

struct PlyProperty {
  PlyType type = PlyType::float32;
  PlyType count_type = PlyType::uint8;  ///< of a list
  bool is_list = false;
  bool is_corners = false;                 ///< the vertices of a face
  std::size_t coordinate = kNoCoordinate;  ///< 0, 1, 2 for x, y, z
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
};

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyType type_named(std::string_view name, const ByteReader& reader) {
  constexpr std::array<std::string_view, 8> kOld = {"char", "uchar", "short", "ushort",
                                                    "int",  "uint",  "float", "double"};
  constexpr std::array<std::string_view, 8> kNew = {"int8",  "uint8",  "int16",   "uint16",
                                                    "int32", "uint32", "float32", "float64"};
  for (std::size_t i = 0; i < kOld.size(); ++i)
    if (name == kOld[i] || name == kNew[i]) return static_cast<PlyType>(i);
  reader.fail("unknown type of a property in the header, " + quoted(name));
}

PlyProperty property_of(const std::vector<std::string_view>& words, const ByteReader& reader) {
  PlyProperty property;
  property.is_list = words.size() == 5 && words[1] == "list";
  if (!property.is_list && words.size() != 3) reader.fail("a property in the header is not understood");
  if (property.is_list) property.count_type = type_named(words[2], reader);
  property.type = type_named(words[words.size() - 2], reader);
  property.is_corners = property.is_list && (words[4] == "vertex_indices" || words[4] == "vertex_index");
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  if (!property.is_list)
    property.coordinate =
        static_cast<std::size_t>(std::find(kNames.begin(), kNames.end(), words[2]) - kNames.begin());
  return property;
}

PlyFormat format_named(std::string_view name, const ByteReader& reader) {
  if (name == "ascii") return PlyFormat::text;
  if (name == "binary_little_endian") return PlyFormat::little_endian;
  if (name == "binary_big_endian") return PlyFormat::big_endian;
  reader.fail("unknown PLY format " + quoted(name));
}

PlyHeader read_header(ByteReader& reader) {
  const auto first = words_of(reader.content_line());
  if (first.size() != 1 || first[0] != "ply") reader.fail("not a PLY file: it does not begin with ply");
  PlyHeader header;
  bool has_format = false;
  while (!reader.empty()) {
    const auto words = words_of(reader.line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header" && has_format) return header;
    if (words[0] == "format" && words.size() == 3 && !has_format) {
      header.format = format_named(words[1], reader);
      has_format = true;
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({std::string(words[1]), count_word(words[2], reader), {}});
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(words, reader));
    } else {
      reader.fail("a line of the PLY header is not understood");
    }
  }
  reader.fail("the PLY header does not end");
}

/// A value of a binary file.
double value_of(PlyType type, bool swap, ByteReader& reader) {
  switch (type) {
    case PlyType::int8:
      return reader.number<std::int8_t>(swap);
    case PlyType::uint8:
      return reader.number<std::uint8_t>(swap);
    case PlyType::int16:
      return reader.number<std::int16_t>(swap);
    case PlyType::uint16:
      return reader.number<std::uint16_t>(swap);
    case PlyType::int32:
      return reader.number<std::int32_t>(swap);
    case PlyType::uint32:
      return reader.number<std::uint32_t>(swap);
    case PlyType::float32:
      return reader.number<float>(swap);
    case PlyType::float64:
      return reader.number<double>(swap);
  }
  return 0;
}

/// The corner of a face: one that no vertex can be is refused later, with all that are not there.
std::uint32_t corner_of(double value, const ByteReader& reader) {
  if (!(value >= 0 && value < std::numeric_limits<std::uint32_t>::max()))
    reader.fail("a face names a vertex that cannot be there");
  return static_cast<std::uint32_t>(value);
}

void read_corners(const PlyProperty& property, std::uint64_t count, bool swap, ByteReader& reader,
                  Polygons& faces) {
  for (std::uint64_t i = 0; i < count; ++i)
    faces.add(corner_of(value_of(property.type, swap, reader), reader));
  faces.close();
}

Vertex read_binary(const PlyElement& element, bool swap, ByteReader& reader, Polygons* faces) {
  Vertex vertex{};
  for (const PlyProperty& property : element.properties) {
    if (property.is_list) {
      const double count = value_of(property.count_type, swap, reader);
      if (!(count >= 0)) reader.fail("a list has a negative length");
      const auto length = static_cast<std::uint64_t>(std::min(count, 1e15));
      reader.require_room(length, size_of(property.type), "entries of a list");
      if (faces != nullptr && property.is_corners) {
        read_corners(property, length, swap, reader, *faces);
      } else {
        reader.bytes(length * size_of(property.type));
      }
    } else if (property.coordinate == kNoCoordinate) {
      reader.bytes(size_of(property.type));
    } else {
      vertex[property.coordinate] = value_of(property.type, swap, reader);
    }
  }
  return vertex;
}

void require_numbers(const std::vector<std::string_view>& words, std::size_t begin, std::size_t end,
                     const ByteReader& reader) {
  for (std::size_t i = begin; i < end; ++i) {
    if (!number_of(words[i])) reader.fail(quoted(words[i]) + " is not a number");
  }
}

Vertex read_text(const PlyElement& element, ByteReader& reader, std::vector<std::string_view>& words,
                 Polygons* faces) {
  split_words(reader.content_line(), words);
  Vertex vertex{};
  std::size_t at = 0;
  for (const PlyProperty& property : element.properties) {
    if (at >= words.size()) reader.fail("a line has too few values");
    std::size_t end = at + 1;
    if (property.is_list) {
      const std::uint64_t length = count_word(words[at], reader);
      if (length >= words.size() - at) reader.fail("a line has too few values");
      end += length;
    }
    if (property.coordinate != kNoCoordinate) {
      vertex[property.coordinate] = real_word(words[at], reader);
    } else {
      require_numbers(words, at, end, reader);
    }
    if (faces != nullptr && property.is_corners) {
      for (std::size_t i = at + 1; i < end; ++i) faces->add(corner_of(*number_of(words[i]), reader));
      faces->close();
    }
    at = end;
  }
  if (at != words.size()) reader.fail("a line has too many values");
  return vertex;
}

/// The fewest bytes that one of the element can take.
std::uint64_t least_size(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += format == PlyFormat::text ? 2 : size_of(property.is_list ? property.count_type : property.type);
  return format == PlyFormat::text && size > 0 ? size - 1 : size;
}

bool has_coordinates(const PlyElement& element) {
  std::array<int, 4> seen{};
  for (const PlyProperty& property : element.properties) ++seen[property.coordinate];
  return seen[0] == 1 && seen[1] == 1 && seen[2] == 1;
}

void require_corners(const MeshText& mesh, const ByteReader& reader) {
  for (const std::uint32_t corner : mesh.faces.corners) {
    if (corner >= mesh.vertices.size())
      reader.fail("vertex " + std::to_string(corner) +
                  " is not there: " + std::to_string(mesh.vertices.size()) + " are, counted from 0");
  }
}

}  // namespace

MeshText ply_mesh(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  const PlyHeader header = read_header(reader);
  const bool swap = (header.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big);
  MeshText mesh;
  std::vector<std::string_view> words;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    const bool wanted = element.name == "vertex";
    if (wanted && !has_coordinates(element)) reader.fail("its vertices have no properties x, y and z");
    if (wanted && !mesh.vertices.empty()) reader.fail("two elements are called vertex");
    reader.require_room(element.count, least_size(element, header.format), "of " + quoted(element.name));
    Polygons* faces = element.name == "face" ? &mesh.faces : nullptr;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const Vertex vertex = header.format == PlyFormat::text ? read_text(element, reader, words, faces)
                                                             : read_binary(element, swap, reader, faces);
      if (wanted) mesh.vertices.push_back(vertex);
    }
  }
  reader.require_end();
  require_corners(mesh, reader);
  return mesh;
}

}  // namespace raygauge::cli
