// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// OFF as in the manual of Geomview: counts, vertices one a line, faces one a line.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"

namespace raygauge::cli {
namespace {

constexpr bool kBigEndian = std::endian::native == std::endian::big;

/// "COFF BINARY": what the first line of an OFF file says.
struct OffHeader {
  bool binary = false;
  std::size_t extra = 0;  ///< numbers of a vertex beside its coordinates, in a binary file
};

/// Takes the header's words away; the counts may follow on the same line, even without a blank: OFF3 1 0.
OffHeader off_header(std::vector<std::string_view>& words, const ByteReader& reader) {
  const std::string_view first = words[0];
  const std::size_t end = first.find_last_not_of("0123456789") + 1;
  if (!first.substr(0, end).ends_with("OFF")) reader.fail("not an OFF file: it does not begin with OFF");
  std::string_view prefix = first.substr(0, end - 3);
  OffHeader header;
  const auto take = [&prefix](std::string_view mark) {
    const bool there = prefix.starts_with(mark);
    if (there) prefix.remove_prefix(mark.size());
    return there;
  };
  if (take("ST")) header.extra += 2;
  if (take("C")) header.extra += 4;
  if (take("N")) header.extra += 3;
  if (!prefix.empty())
    reader.fail("an OFF file of another kind, '" + std::string(first.substr(0, 20)) +
                "'; OFF with three coordinates is read");
  words[0].remove_prefix(end);
  if (words[0].empty()) words.erase(words.begin());
  header.binary = words.size() == 1 && words[0] == "BINARY";
  return header;
}

/// The byte order of the counts: big endian, as the format is defined, unless they cannot be true and those
/// of the other order can. (Some programs write the order of their machine.)
bool is_little_endian(ByteReader reader, std::uint64_t bytes_of_vertex) {
  const auto may_follow = [&](bool swap) {
    ByteReader counts = reader;
    const auto vertices = counts.number<std::uint32_t>(swap);
    const auto faces = counts.number<std::uint32_t>(swap);
    counts.number<std::uint32_t>(swap);  // edges
    return vertices * bytes_of_vertex + faces * std::uint64_t{sizeof(std::uint32_t)} <= counts.size();
  };
  return !may_follow(!kBigEndian) && may_follow(kBigEndian);
}

/// Whether so many faces are what is left: a count of corners, the corners and, in one of two dialects, a
/// count of numbers of a colour and these.
bool read_faces(ByteReader reader, std::uint32_t faces, bool colours, bool swap, Polygons& polygons) {
  polygons = {};
  const auto read_list = [&](bool corners) {
    if (reader.size() < sizeof(std::uint32_t)) return false;
    const std::uint64_t count = reader.number<std::uint32_t>(swap);
    if (reader.size() < count * sizeof(std::uint32_t)) return false;
    if (!corners) {
      reader.bytes(count * sizeof(std::uint32_t));
      return true;
    }
    for (std::uint64_t i = 0; i < count; ++i) polygons.add(reader.number<std::uint32_t>(swap));
    polygons.close();
    return true;
  };
  for (std::uint32_t face = 0; face < faces; ++face) {
    if (!read_list(true) || (colours && !read_list(false))) return false;
  }
  return reader.empty();
}

MeshText binary_off_mesh(ByteReader& reader, std::size_t extra) {
  const std::size_t skipped = extra * sizeof(float);
  const std::size_t size = 3 * sizeof(float) + skipped;
  const bool swap = is_little_endian(reader, size) ? kBigEndian : !kBigEndian;
  const auto count = reader.number<std::uint32_t>(swap);
  const auto faces = reader.number<std::uint32_t>(swap);
  reader.bytes(sizeof(std::uint32_t));  // edges
  reader.require_room(count, size, "vertices");
  MeshText mesh;
  mesh.vertices.resize(count);
  for (Vertex& vertex : mesh.vertices) {
    for (double& value : vertex) value = reader.number<float>(swap);
    reader.bytes(skipped);
  }
  if (!read_faces(reader, faces, true, swap, mesh.faces) &&
      !read_faces(reader, faces, false, swap, mesh.faces))
    reader.fail("the " + std::to_string(faces) +
                " faces that the header promises are not what follows the vertices");
  for (const std::uint32_t corner : mesh.faces.corners) {
    if (corner >= count)
      reader.fail("vertex " + std::to_string(corner) + " is not there: " + std::to_string(count) +
                  " are, counted from 0");
  }
  return mesh;
}

using Words = std::vector<std::string_view>;

/// Each face is a count and so many numbers of vertices, with a colour or without.
void read_faces(std::uint64_t count, std::uint64_t vertices, ByteReader& reader, Polygons& polygons) {
  Words words;
  for (std::uint64_t face = 0; face < count; ++face) {
    split_words(reader.content_line(), words);
    const std::uint64_t corners = count_word(words[0], reader);
    if (corners < 1 || corners >= words.size())
      reader.fail("a face of " + std::to_string(corners) + " vertices has " +
                  std::to_string(words.size() - 1) + " numbers");
    for (std::uint64_t i = 1; i <= corners; ++i) {
      const std::uint64_t vertex = count_word(words[i], reader);
      if (vertex >= vertices)
        reader.fail("vertex " + std::to_string(vertex) + " is not there: " + std::to_string(vertices) +
                    " are, counted from 0");
      polygons.add(static_cast<std::uint32_t>(vertex));
    }
    polygons.close();
    for (std::uint64_t i = corners + 1; i < words.size(); ++i) real_word(words[i], reader);
  }
}

MeshText text_off_mesh(const Words& counts, ByteReader& reader) {
  if (counts.size() != 2 && counts.size() != 3)
    reader.fail("the numbers of vertices, faces and edges are expected");
  const std::uint64_t count = count_word(counts[0], reader), faces = count_word(counts[1], reader);
  if (counts.size() == 3) count_word(counts[2], reader);  // edges: nothing depends on them, many files say 0
  constexpr std::uint64_t kShortest = 5;                  // "0 0 0"
  reader.require_room(count, kShortest, "vertices");
  MeshText mesh;
  mesh.vertices.resize(count);
  Words words;
  for (Vertex& vertex : mesh.vertices) {
    split_words(reader.content_line(), words);
    if (words.size() < 3) reader.fail("a vertex has fewer than three coordinates");
    for (std::size_t i = 0; i < words.size(); ++i) {
      const double value = real_word(words[i], reader);
      if (i < 3) vertex[i] = value;
    }
  }
  read_faces(faces, count, reader, mesh.faces);
  reader.require_end();
  return mesh;
}

}  // namespace

MeshText off_mesh(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  Words words = words_of(reader.content_line());
  const OffHeader header = off_header(words, reader);
  if (header.binary) return binary_off_mesh(reader, header.extra);
  if (words.empty()) words = words_of(reader.content_line());
  return text_off_mesh(words, reader);
}

}  // namespace raygauge::cli
