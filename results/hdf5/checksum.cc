// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <vector>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge::hdf5 {
namespace {

constexpr std::string_view kMark = "raygauge CRC-32 ";
constexpr std::size_t kLineBytes = kMark.size() + 9;

std::string line_of(uLong sum) {
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "%08lx\n", sum);
  return std::string(kMark) + digits.data();
}

uLong sum_with(uLong sum, std::string_view bytes) {
  return ::crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

/// Of the first `size` bytes of the file.
uLong sum_of(std::ifstream& file, std::uintmax_t size) {
  std::vector<char> buffer(std::size_t{1} << 20);
  uLong sum = ::crc32_z(0, nullptr, 0);
  for (std::uintmax_t left = size; left > 0 && file;) {
    file.read(buffer.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(left, buffer.size())));
    sum = sum_with(sum, std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
    left -= static_cast<std::uintmax_t>(file.gcount());
  }
  return sum;
}

std::ifstream opened(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ResultsError(path.string() + ": cannot open: " + system_reason(errno));
  return file;
}

}  // namespace

std::string checksum_line(std::string_view bytes) { return line_of(sum_with(0, bytes)); }

void append_checksum(const std::filesystem::path& path) {
  std::ifstream content = opened(path);
  const std::string line = line_of(sum_of(content, std::filesystem::file_size(path)));
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << line;
  if (!content || !file.flush())
    throw ResultsError(path.string() + ": cannot write: " + system_reason(errno));
}

Checksum checksum_of(const std::filesystem::path& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size < kLineBytes) return Checksum::none;
  std::ifstream file = opened(path);
  std::string line(kLineBytes, '\0');
  file.seekg(-static_cast<std::streamoff>(kLineBytes), std::ios::end);
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (!line.starts_with(kMark)) return Checksum::none;
  file.seekg(0);
  return line == line_of(sum_of(file, size - kLineBytes)) ? Checksum::right : Checksum::wrong;
}

}  // namespace raygauge::hdf5
