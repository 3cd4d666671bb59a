// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/vertex_reader.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <system_error>

#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r";
constexpr bool kBigEndian = std::endian::native == std::endian::big;

/// "COFF BINARY": what the first line of an OFF file says.
struct OffHeader {
  bool binary = false;
  std::size_t extra = 0;  ///< numbers of a vertex beside its coordinates, in a binary file
};

OffHeader off_header(const std::vector<std::string_view>& words, const ByteReader& reader) {
  if (words.empty() || !words[0].ends_with("OFF")) reader.fail("not an OFF file: it does not begin with OFF");
  std::string_view prefix = words[0].substr(0, words[0].size() - 3);
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
    reader.fail("an OFF file of another kind, '" + std::string(words[0].substr(0, 20)) +
                "'; OFF with three coordinates is read");
  header.binary = words.size() > 1 && words[1] == "BINARY";
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

std::vector<Vertex> binary_off_vertices(ByteReader& reader, std::size_t extra) {
  const std::size_t skipped = extra * sizeof(float);
  const std::size_t size = 3 * sizeof(float) + skipped;
  const bool swap = is_little_endian(reader, size) ? kBigEndian : !kBigEndian;
  const auto count = reader.number<std::uint32_t>(swap);
  reader.bytes(2 * sizeof(std::uint32_t));  // faces and edges
  reader.require_room(count, size, "vertices");
  std::vector<Vertex> vertices(count);
  for (Vertex& vertex : vertices) {
    for (double& value : vertex) value = reader.number<float>(swap);
    reader.bytes(skipped);
  }
  return vertices;
}

}  // namespace

std::string_view ByteReader::line() {
  const std::size_t end = std::min(left_.find('\n'), left_.size());
  const std::string_view line = left_.substr(0, end);
  left_.remove_prefix(std::min(end + 1, left_.size()));
  return line;
}

std::string_view ByteReader::content_line() {
  while (!left_.empty()) {
    std::string_view content = line();
    content = content.substr(0, content.find('#'));
    if (content.find_first_not_of(kBlanks) != std::string_view::npos) return content;
  }
  fail("the file ends before what its header promises");
}

std::string_view ByteReader::bytes(std::size_t count) {
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

void ByteReader::fail(const std::string& reason) const { throw InvalidParameterError(name_ + ": " + reason); }

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

double real_word(std::string_view word, const ByteReader& reader) {
  double value = 0;
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + (plus ? 1 : 0), end, value);
  if (error == std::errc::invalid_argument || stop != end)
    reader.fail("'" + std::string(word.substr(0, 40)) + "' is not a number");
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

std::uint64_t count_word(std::string_view word, const ByteReader& reader) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size())
    reader.fail("'" + std::string(word.substr(0, 40)) + "' is not a count");
  return value;
}

std::vector<Vertex> off_vertices(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  std::vector<std::string_view> words = words_of(reader.content_line());
  const OffHeader header = off_header(words, reader);
  if (header.binary) return binary_off_vertices(reader, header.extra);
  words.erase(words.begin());
  if (words.empty()) words = words_of(reader.content_line());
  if (words.empty()) reader.fail("the numbers of vertices and faces are missing");
  const std::uint64_t count = count_word(words[0], reader);
  constexpr std::uint64_t kShortest = 5;  // "0 0 0"
  reader.require_room(count, kShortest, "vertices");
  std::vector<Vertex> vertices(count);
  for (Vertex& vertex : vertices) {
    words = words_of(reader.content_line());
    if (words.size() < 3) reader.fail("a vertex has fewer than three coordinates");
    for (std::size_t i = 0; i < 3; ++i) vertex[i] = real_word(words[i], reader);
  }
  return vertices;
}

namespace {
constexpr std::size_t kStlHead = 84;
constexpr std::size_t kStlFacet = 50;
}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHead) return false;
  const std::string name;
  ByteReader reader(bytes.substr(kStlHead - sizeof(std::uint32_t)), name);
  const std::uint64_t facets = reader.number<std::uint32_t>(kBigEndian);
  return bytes.size() == kStlHead + facets * kStlFacet;
}

std::vector<Vertex> binary_stl_vertices(std::string_view bytes) {
  const std::string name;
  ByteReader reader(bytes.substr(kStlHead), name);
  std::vector<Vertex> vertices;
  while (reader.size() >= kStlFacet) {
    reader.bytes(3 * sizeof(float));  // the normal
    for (int corner = 0; corner < 3; ++corner) {
      Vertex& vertex = vertices.emplace_back();
      for (double& value : vertex) value = reader.number<float>(kBigEndian);
    }
    reader.bytes(sizeof(std::uint16_t));
  }
  return vertices;
}

}  // namespace raygauge::cli
