// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/input_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "engine/exceptions.h"

namespace raygauge::cli {
namespace {

struct FileClose {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

[[noreturn]] void throw_reason(const std::string& path) {
  const int reason = errno;
  throw InvalidParameterError(input_name(path) + ": " + std::generic_category().message(reason));
}

std::string read_all(std::FILE* file, const std::string& path) {
  constexpr std::size_t kChunk = 1 << 20;
  std::string bytes;
  std::size_t size = 0;
  while (true) {
    bytes.resize(size + kChunk);
    const std::size_t got = std::fread(bytes.data() + size, 1, kChunk, file);
    size += got;
    if (got < kChunk) break;
  }
  if (std::ferror(file) != 0) throw_reason(path);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string input_name(const std::string& path) { return path == kStandardInput ? "standard input" : path; }

std::string read_input(const std::string& path) {
  if (path == kStandardInput) return read_all(stdin, path);
  const std::unique_ptr<std::FILE, FileClose> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) throw_reason(path);
  return read_all(file.get(), path);
}

}  // namespace raygauge::cli
