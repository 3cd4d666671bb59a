// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// PCD as the Point Cloud Library writes it, version 0.7.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::size_t kNoCoordinate = 3;

/// One number of a point, or several that are passed over.
struct Field {
  std::size_t coordinate = kNoCoordinate;
  std::uint64_t size = 4, count = 1;
  char type = 'F';
};

class PcdReader {
 public:
  PcdReader(std::string_view bytes, const std::string& name) : reader_(bytes, name), name_(name) {}

  MeshText read() {
    read_header();
    std::uint64_t numbers = 0, bytes = 0;
    for (const Field& field : fields_) {
      numbers += field.count;
      bytes += field.count * field.size;
    }
    reader_.require_room(points_, is_text_ ? 2 * numbers - 1 : bytes, "points");
    MeshText text;
    for (std::uint64_t i = 0; i < points_; ++i) {
      text.vertices.push_back(is_text_ ? text_point(numbers) : binary_point());
      require_measured(text.vertices.back(), i);
    }
    if (is_text_) reader_.require_end();
    if (!is_text_ && !reader_.empty()) reader_.fail("the file goes on behind what its header promises");
    return text;
  }

 private:
  void read_header() {
    while (true) {
      split_words(reader_.content_line(), words_);
      const std::string_view key = words_.front();
      if (!seen_.insert(std::string(key)).second) reader_.fail(std::string(key) + " stands there twice");
      if (key == "DATA") return take_data();
      if (key == "FIELDS") {
        take_fields();
      } else if (key == "SIZE" || key == "TYPE" || key == "COUNT") {
        take_layout(key);
      } else if (key == "POINTS" || key == "WIDTH" || key == "HEIGHT") {
        if (words_.size() != 2) reader_.fail(std::string(key) + " is one number");
        (key == "POINTS" ? points_ : key == "WIDTH" ? width_ : height_) = count_word(words_[1], reader_);
      } else if (key != "VERSION" && key != "VIEWPOINT") {
        reader_.fail(quoted(key) + " is no line of the header of a PCD file");
      }
    }
  }

  void take_fields() {
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    std::array<int, 4> seen{};
    for (std::size_t i = 1; i < words_.size(); ++i) {
      Field field;
      while (field.coordinate > 0 && kNames[field.coordinate - 1] != words_[i]) --field.coordinate;
      field.coordinate = field.coordinate > 0 ? field.coordinate - 1 : kNoCoordinate;
      ++seen[field.coordinate];
      fields_.push_back(field);
    }
    if (seen[0] != 1 || seen[1] != 1 || seen[2] != 1) reader_.fail("its points have no fields x, y and z");
  }

  void take_layout(std::string_view key) {
    if (fields_.empty() || words_.size() != fields_.size() + 1)
      reader_.fail(std::string(key) + " is not one word a field, behind FIELDS");
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const std::string_view word = words_[i + 1];
      if (key == "TYPE") {
        fields_[i].type = word == "F" || word == "I" || word == "U" ? word.front() : '?';
      } else {
        (key == "SIZE" ? fields_[i].size : fields_[i].count) = count_word(word, reader_);
      }
    }
  }

  void take_data() {
    const std::string_view form = words_.size() == 2 ? words_[1] : "";
    if (form == "binary_compressed")
      reader_.fail("DATA binary_compressed is not read: pcl_convert_pcd_ascii_binary IN OUT 1 writes binary");
    if (form != "ascii" && form != "binary") reader_.fail("DATA is ascii or binary");
    is_text_ = form == "ascii";
    if (fields_.empty()) reader_.fail("its points have no fields x, y and z");
    if (points_ == 0) throw EmptySetError(name_ + ": no points");
    const bool grid = seen_.contains("WIDTH") && seen_.contains("HEIGHT");
    if (grid && (width_ == 0 || points_ % width_ != 0 || points_ / width_ != height_))
      reader_.fail("WIDTH times HEIGHT is not POINTS");
    if (!is_text_ && !(seen_.contains("SIZE") && seen_.contains("TYPE")))
      reader_.fail("binary points need SIZE and TYPE");
    for (const Field& field : fields_) {
      if (field.count == 0 || field.count > kMost || field.size == 0 || field.size > 8)
        reader_.fail("a field of no or of too many numbers");
      const bool real = field.type == 'F' && (field.size == 4 || field.size == 8) && field.count == 1;
      if (field.coordinate != kNoCoordinate && !real)
        reader_.fail("x, y and z are read as single numbers of TYPE F and SIZE 4 or 8");
    }
  }

  Vertex text_point(std::uint64_t numbers) {
    split_words(reader_.content_line(), words_);
    if (words_.size() != numbers)
      reader_.fail("a point of " + std::to_string(words_.size()) + " numbers; the header promises " +
                   std::to_string(numbers));
    Vertex vertex{};
    std::size_t at = 0;
    for (const Field& field : fields_) {
      if (field.coordinate != kNoCoordinate) vertex[field.coordinate] = real_word(words_[at], reader_);
      at += field.count;
    }
    return vertex;
  }

  Vertex binary_point() {
    constexpr bool kSwap = std::endian::native == std::endian::big;
    Vertex vertex{};
    for (const Field& field : fields_) {
      if (field.coordinate == kNoCoordinate) {
        reader_.bytes(field.size * field.count);
      } else {
        vertex[field.coordinate] =
            field.size == 8 ? reader_.number<double>(kSwap) : double{reader_.number<float>(kSwap)};
      }
    }
    return vertex;
  }

  /// Cameras write NaN where they saw nothing.
  void require_measured(const Vertex& vertex, std::uint64_t i) const {
    for (const double x : vertex) {
      if (!std::isfinite(x))
        throw NonFiniteError(name_ + ": point " + std::to_string(i) +
                             ", counted from 0, is not finite: leave out what was not measured");
    }
  }

  static constexpr std::uint64_t kMost = 1 << 20;

  ByteReader reader_;
  const std::string& name_;
  std::vector<std::string_view> words_;
  std::vector<Field> fields_;
  std::set<std::string> seen_;  // keys of the header
  std::uint64_t points_ = 0, width_ = 0, height_ = 0;
  bool is_text_ = true;
};

}  // namespace

MeshText pcd_points(std::string_view bytes, const std::string& name) { return PcdReader(bytes, name).read(); }

}  // namespace raygauge::cli
