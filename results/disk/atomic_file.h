// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace raygauge {

/// Takes the next bytes of what is written. Throws ResultsError with the system's reason.
using ByteSink = std::function<void(std::string_view bytes)>;

/// Gives all bytes of a file to a sink, part by part.
using ByteSource = std::function<void(const ByteSink& put)>;

/// Replaces `path` by a file of the bytes of `source`: written to `temporary` (in the same file system; if
/// empty, a name beside `path` that no other process uses), brought to the disk, renamed. At every moment
/// `path` is its old self or complete; its permissions stay. Throws ResultsError with the system's reason,
/// and what `source` throws; `temporary` is then gone and `path` untouched.
void write_atomically(const std::filesystem::path& path, const ByteSource& source,
                      std::filesystem::path temporary = {});
void write_atomically(const std::filesystem::path& path, std::string_view bytes,
                      std::filesystem::path temporary = {});

/// Writes the bytes of `source` to a device, a FIFO or an open file, which is there and stays. Throws as
/// above.
void write_in_place(const std::filesystem::path& path, const ByteSource& source);

/// Brings the file `temporary` to the disk and renames it to `path`. Throws ResultsError; `temporary` is then
/// gone and `path` untouched.
void move_durably(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// A file that grows block by block.
class AppendedFile {
 public:
  /// Opens the file at `path`, which must exist, and locks it (see is_locked()). Throws ResultsError.
  explicit AppendedFile(std::filesystem::path path);
  ~AppendedFile();
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  /// Appends a block and brings it to the disk. Thread safe: blocks follow each other whole, and threads wait
  /// for the disk together. Throws ResultsError with the system's reason; a block that did not fit is then
  /// taken back. A kill may leave a part of the last block.
  void append(std::string_view block);

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::mutex mutex_;  ///< guards the end of the file
};

/// The whole file. Throws ResultsError with the system's reason.
std::string file_bytes(const std::filesystem::path& path);

/// The system's words for an errno value: "No space left on device".
std::string system_reason(int error_number);

}  // namespace raygauge
