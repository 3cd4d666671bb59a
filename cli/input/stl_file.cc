// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr bool kBigEndian = std::endian::native == std::endian::big;
constexpr std::size_t kHead = 80;  // of any text
constexpr std::size_t kFirstFacet = kHead + sizeof(std::uint32_t);
constexpr std::size_t kFacet = 50;

std::uint64_t facets_promised(std::string_view bytes) {
  const std::string name;
  return ByteReader(bytes.substr(kHead), name).number<std::uint32_t>(kBigEndian);
}

std::uint64_t size_promised(std::string_view bytes) { return kFirstFacet + facets_promised(bytes) * kFacet; }

std::vector<Vertex> binary_vertices(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes.substr(kFirstFacet), name);
  std::vector<Vertex> vertices;
  while (!reader.empty()) {
    reader.bytes(3 * sizeof(float));  // the normal
    for (int corner = 0; corner < 3; ++corner) {
      Vertex& vertex = vertices.emplace_back();
      for (double& value : vertex) {
        value = reader.number<float>(kBigEndian);
        if (!std::isfinite(value))
          throw NonFiniteError(name + ": facet " + std::to_string(vertices.size() / 3 + 1) +
                               " has a coordinate that is not a finite number");
      }
    }
    reader.bytes(sizeof(std::uint16_t));  // attributes
  }
  return vertices;
}

bool is_word(std::string_view word, std::string_view wanted) {
  return std::equal(word.begin(), word.end(), wanted.begin(), wanted.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// "-nan(ind)", "-1.#IND", "1.#QNAN".
bool is_undefined(std::string_view word) {
  for (const std::string_view mark : {"nan", "NaN", "NAN", ".#IND", ".#QNAN"}) {
    if (word.find(mark) != std::string_view::npos) return true;
  }
  return false;
}

/// A text file: facets of three vertices inside one solid, or several.
class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name) : reader_(text, name) {}

  std::vector<Vertex> read() {
    while (next()) {
      if (!is_word(words_[0], "solid")) reader_.fail("solid is expected, not " + quoted(words_[0]));
      read_solid();
    }
    return std::move(vertices_);
  }

 private:
  bool next() {
    do {
      if (reader_.empty()) return false;
      split_words(reader_.line(), words_);
    } while (words_.empty());
    return true;
  }

  /// The next line, which must begin with these words and have so many more.
  void expect(std::initializer_list<std::string_view> begin, std::size_t more) {
    std::string wanted;
    for (const std::string_view word : begin) wanted += (wanted.empty() ? "" : " ") + std::string(word);
    if (!next()) reader_.fail("the file ends where " + wanted + " is expected");
    const bool begins =
        words_.size() >= begin.size() &&
        std::equal(begin.begin(), begin.end(), words_.begin(),
                   [](std::string_view wish, std::string_view word) { return is_word(word, wish); });
    if (!begins) reader_.fail(wanted + " is expected, not " + quoted(words_[0]));
    if (words_.size() != begin.size() + more)
      reader_.fail(wanted + " with " + std::to_string(words_.size() - begin.size()) + " words behind it");
  }

  void read_solid() {
    while (true) {
      if (!next()) reader_.fail("the file ends inside a solid: there is no endsolid");
      if (is_word(words_[0], "endsolid")) return;
      if (!is_word(words_[0], "facet") || words_.size() != 5 || !is_word(words_[1], "normal"))
        reader_.fail("facet normal and three numbers are expected, not " + quoted(words_[0]));
      // The normal of a facet without area is written as NaN, in several spellings.
      for (std::size_t i = 2; i < 5; ++i) {
        if (!number_of(words_[i]) && !is_undefined(words_[i]))
          reader_.fail(quoted(words_[i]) + " is not a number");
      }
      read_facet();
    }
  }

  void read_facet() {
    expect({"outer", "loop"}, 0);
    for (int corner = 0; corner < 3; ++corner) {
      expect({"vertex"}, 3);
      vertices_.push_back(
          {real_word(words_[1], reader_), real_word(words_[2], reader_), real_word(words_[3], reader_)});
    }
    expect({"endloop"}, 0);
    expect({"endfacet"}, 0);
  }

  ByteReader reader_;
  std::vector<std::string_view> words_;
  std::vector<Vertex> vertices_;
};

/// Every three vertices are a facet.
MeshText facets_of(std::vector<Vertex> vertices) {
  MeshText mesh;
  mesh.vertices = std::move(vertices);
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.faces.add(i);
    if (i % 3 == 2) mesh.faces.close();
  }
  return mesh;
}

}  // namespace

MeshText stl_mesh(std::string_view bytes, const std::string& name) {
  const bool has_count = bytes.size() >= kFirstFacet;
  if (has_count && bytes.size() == size_promised(bytes)) return facets_of(binary_vertices(bytes, name));
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  if (is_word(bytes.substr(first, 5), "solid") && bytes.find('\0') == std::string_view::npos)
    return facets_of(TextReader(bytes, name).read());
  std::string reason = "neither a text STL file, which begins with solid, nor a whole binary one";
  if (has_count) {
    reason += ": " + std::to_string(facets_promised(bytes)) + " facets would be " +
              std::to_string(size_promised(bytes)) + " bytes, it has " + std::to_string(bytes.size());
  }
  throw InvalidParameterError(name + ": " + reason);
}

}  // namespace raygauge::cli
