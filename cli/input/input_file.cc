// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/input_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>

#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::size_t kChunk = 1 << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::uint64_t kMebibyte = 1 << 20;

std::atomic<std::uint64_t>& limit() {
  static std::atomic<std::uint64_t> bytes = kMaxInput * kMebibyte;
  return bytes;
}

[[noreturn]] void throw_reason(const std::string& name, int reason) {
  throw InvalidParameterError(name + ": " + std::generic_category().message(reason));
}

}  // namespace

/// zlib passes through what is not compressed.
struct InputFile::Stream {
  explicit Stream(gzFile opened) : file(opened) {}
  ~Stream() { gzclose_r(file); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  gzFile file;
};

InputFile::InputFile(const std::string& path) : name_(input_name(path)) {
  const int descriptor = path == kStandardInput ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                                : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw_reason(name_, errno);
  gzFile file = gzdopen(descriptor, "rb");
  if (file == nullptr) {
    ::close(descriptor);
    throw InvalidParameterError(name_ + ": does not fit into memory");
  }
  stream_ = std::make_unique<Stream>(file);
  gzbuffer(file, 1 << 17);
}

InputFile::~InputFile() = default;

std::size_t InputFile::read(char* out, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const auto wanted = static_cast<unsigned>(std::min(size - done, kChunk));
    errno = 0;
    const int got = gzread(stream_->file, out + done, wanted);
    const int reason = errno;
    int code = Z_OK;
    gzerror(stream_->file, &code);
    if (code == Z_ERRNO) throw_reason(name_, reason == 0 ? EIO : reason);
    if (got < 0 || code == Z_BUF_ERROR || code == Z_DATA_ERROR)
      throw InvalidParameterError(name_ + ": gzip data that is truncated or damaged");
    done += static_cast<std::size_t>(got);
    read_ += static_cast<std::uint64_t>(got);
    if (read_ > limit() && gzdirect(stream_->file) == 0)
      throw InvalidParameterError(name_ + ": compressed data of more than " +
                                  std::to_string(limit() / kMebibyte) +
                                  " MiB; --max-input sets another limit");
    if (got == 0) break;
  }
  return done;
}

void limit_compressed_input(const std::string& mebibytes) {
  std::uint64_t number = 0;
  const char* end = mebibytes.data() + mebibytes.size();
  const auto [stop, error] = std::from_chars(mebibytes.data(), end, number);
  if (error != std::errc() || stop != end || number == 0 ||
      number > std::numeric_limits<std::uint64_t>::max() / kMebibyte)
    throw InvalidParameterError("--max-input takes a number of MiB, as in 4096; got '" + mebibytes + "'");
  limit() = number * kMebibyte;
}

std::uint64_t compressed_input_limit() { return limit(); }

std::string input_name(const std::string& path) { return path == kStandardInput ? "standard input" : path; }

std::string read_input(const std::string& path) {
  InputFile file(path);
  std::string bytes;
  std::size_t size = 0;
  while (true) {
    bytes.resize(size + kChunk);
    const std::size_t got = file.read(bytes.data() + size, kChunk);
    size += got;
    if (got < kChunk) break;
  }
  bytes.resize(size);
  return bytes;
}

std::string read_text_input(const std::string& path) {
  std::string text = read_input(path);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

std::string content_extension(const std::string& path) {
  const auto lower = [](const std::filesystem::path& name) {
    std::string extension = name.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension.empty() ? extension : extension.substr(1);
  };
  const std::filesystem::path name = std::filesystem::path(path).filename();
  const std::string extension = lower(name);
  return extension == "gz" ? lower(name.stem()) : extension;
}

}  // namespace raygauge::cli
