// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raygauge::cli {

using Vertex = std::array<double, 3>;

/// The vertices of mesh files in formats whose header says how many there are. The size of the file is
/// believed, not the header: nothing is reserved for what is not there. Each throws InvalidParameterError,
/// which names the file, for what is not of its format or ends too early.

/// OFF, text or binary of either byte order, also with normals, colours or texture coordinates (NOFF, COFF,
/// STOFF).
std::vector<Vertex> off_vertices(std::string_view bytes, const std::string& name);

/// PLY, text or binary of either byte order.
std::vector<Vertex> ply_vertices(std::string_view bytes, const std::string& name);

/// Binary STL, if that is what the bytes are.
bool is_binary_stl(std::string_view bytes);
std::vector<Vertex> binary_stl_vertices(std::string_view bytes);

/// What is left of a file that is read from front to back.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : left_(bytes), name_(name) {}

  bool empty() const noexcept { return left_.empty(); }
  std::size_t size() const noexcept { return left_.size(); }

  /// The next line without its end.
  std::string_view line();

  /// The next line that holds more than blanks and a comment, without the comment.
  std::string_view content_line();

  /// The next bytes. Throws where fewer are left.
  std::string_view bytes(std::size_t count);

  /// A number of the machine's own byte order, or of the other one.
  template <class T>
  T number(bool swap) {
    std::array<char, sizeof(T)> raw{};
    const std::string_view from = bytes(sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[i] = from[swap ? sizeof(T) - 1 - i : i];
    T value;
    static_assert(sizeof(value) == sizeof(raw));
    __builtin_memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  /// Throws unless `count` things of at least `least` bytes each may follow.
  void require_room(std::uint64_t count, std::uint64_t least, const std::string& things) const;

  [[noreturn]] void fail(const std::string& reason) const;

 private:
  std::string_view left_;
  const std::string& name_;
};

/// The words of a line.
std::vector<std::string_view> words_of(std::string_view line);

/// A whole word as a number. Throws by way of `reader`.
double real_word(std::string_view word, const ByteReader& reader);
std::uint64_t count_word(std::string_view word, const ByteReader& reader);

}  // namespace raygauge::cli
