// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/byte_reader.h"

#include <algorithm>
#include <cmath>

#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r\n";

}  // namespace

std::string_view ByteReader::line() {
  const std::size_t end = std::min(left_.find_first_of("\r\n"), left_.size());
  const std::string_view line = left_.substr(0, end);
  const bool two = left_.substr(end).starts_with("\r\n");
  left_.remove_prefix(std::min(end + (two ? 2 : 1), left_.size()));
  ++line_;
  return line;
}

bool ByteReader::next_content(std::string_view& content) {
  while (!left_.empty()) {
    content = line();
    content = content.substr(0, content.find('#'));
    if (content.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
  return false;
}

std::string_view ByteReader::content_line() {
  std::string_view content;
  if (!next_content(content)) fail("the file ends before what its header promises");
  return content;
}

void ByteReader::require_end() {
  std::string_view content;
  if (next_content(content)) fail("the file goes on behind what its header promises");
}

std::string_view ByteReader::bytes(std::size_t count) {
  among_bytes_ = true;
  if (count > left_.size()) fail("the file ends before what its header promises");
  const std::string_view taken = left_.substr(0, count);
  left_.remove_prefix(count);
  return taken;
}

void ByteReader::require_room(std::uint64_t count, std::uint64_t least, const std::string& things) const {
  if (count <= left_.size() / std::max<std::uint64_t>(least, 1)) return;
  fail("the header promises " + std::to_string(count) + " " + things + ", and " +
       std::to_string(left_.size()) + " bytes are left");
}

std::string ByteReader::place() const {
  return name_ + (line_ == 0 || among_bytes_ ? "" : ":" + std::to_string(line_)) + ": ";
}

void ByteReader::fail(const std::string& reason) const { throw InvalidParameterError(place() + reason); }

void split_words(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  split_words(line, words);
  return words;
}

double real_word(std::string_view word, const ByteReader& reader) {
  const std::optional<double> value = number_of(word);
  if (!value) reader.fail(quoted(word) + " is not a number");
  if (!std::isfinite(*value)) throw NonFiniteError(reader.place() + quoted(word) + non_finite_reason(word));
  return *value;
}

std::uint64_t count_word(std::string_view word, const ByteReader& reader) {
  const std::optional<long> value = integer_of(word);
  if (!value || *value < 0) reader.fail(quoted(word) + " is not a count");
  return static_cast<std::uint64_t>(*value);
}

}  // namespace raygauge::cli
