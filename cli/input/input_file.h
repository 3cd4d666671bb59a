// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace raygauge::cli {

/// The name that stands for standard input.
inline constexpr const char* kStandardInput = "-";

/// How large a compressed input may become: a file of a kilobyte can stand for a gigabyte. In MiB.
inline constexpr std::uint64_t kMaxInput = 2048;

/// Sets another limit for all inputs that are read from now on; for --max-input. Throws InvalidParameterError
/// unless `mebibytes` is a positive integer.
void limit_compressed_input(const std::string& mebibytes);

/// The limit in bytes.
std::uint64_t compressed_input_limit();

/// A file, or standard input for "-", read from front to back. What gzip has compressed is decompressed,
/// whatever its name is.
class InputFile {
 public:
  /// Throws InvalidParameterError with the system's reason: the file is missing, not readable.
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Puts the next `size` bytes at `out`, fewer only at the end. Throws InvalidParameterError: a folder,
  /// truncated or damaged gzip data, compressed data that are larger than the limit.
  std::size_t read(char* out, std::size_t size);

 private:
  struct Stream;
  std::string name_;
  std::uint64_t read_ = 0;  ///< bytes so far
  std::unique_ptr<Stream> stream_;
};

/// All bytes of an InputFile. Throws as it does.
std::string read_input(const std::string& path);

/// The same without the byte order mark of UTF-8 that may stand in front of a text.
std::string read_text_input(const std::string& path);

/// How messages call the input: its path, or "standard input".
std::string input_name(const std::string& path);

/// "off" of "a/b.OFF" and of "a/b.off.gz": what the name says of the content.
std::string content_extension(const std::string& path);

}  // namespace raygauge::cli
