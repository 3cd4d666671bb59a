// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raygauge::cli {

/// What is left of a file that is read from front to back: lines of text, or bytes. It knows the line that it
/// is at.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : left_(bytes), name_(name) {}

  bool empty() const noexcept { return left_.empty(); }
  std::size_t size() const noexcept { return left_.size(); }

  /// The next line without its end: LF, CR LF or CR.
  std::string_view line();

  /// The next line that holds more than blanks and a comment, without the comment. Throws where there is
  /// none.
  std::string_view content_line();

  /// Throws if a line is left that holds more than blanks and a comment.
  void require_end();

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

  /// Throws InvalidParameterError "FILE:LINE: reason", in front of the first line and among bytes "FILE:
  /// reason".
  [[noreturn]] void fail(const std::string& reason) const;

  /// Where fail() says that it is.
  std::string place() const;

 private:
  bool next_content(std::string_view& content);

  std::string_view left_;
  const std::string& name_;
  std::size_t line_ = 0;
  bool among_bytes_ = false;
};

/// The words of a line, or of several, put in the place of those in `words`.
void split_words(std::string_view line, std::vector<std::string_view>& words);
std::vector<std::string_view> words_of(std::string_view line);

/// A whole word as a number. Throws by way of `reader`: InvalidParameterError; NonFiniteError for NaN,
/// infinity and what is too large.
double real_word(std::string_view word, const ByteReader& reader);
std::uint64_t count_word(std::string_view word, const ByteReader& reader);

}  // namespace raygauge::cli
