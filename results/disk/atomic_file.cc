// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "results/exceptions.h"

namespace raygauge {
namespace {

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    const int reason = errno;
    close();
    errno = reason;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int value() const noexcept { return value_; }
  bool close() noexcept {
    const int closed = value_;
    value_ = -1;
    return closed < 0 || ::close(closed) == 0;
  }

 private:
  int value_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path) {
  throw ResultsError(path.string() + ": cannot write: " + system_reason(errno));
}

/// Writes a file that is to take the place of `replaced`, whose permissions it gets.
void write_durably(const std::filesystem::path& path, const ByteSource& source,
                   const std::filesystem::path& replaced) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.value() < 0) fail_to_write(replaced);
  struct stat earlier {};
  // Where they cannot be set, as on some network disks, a file has the default ones.
  if (::stat(replaced.c_str(), &earlier) == 0 && ::fchmod(file.value(), earlier.st_mode & 07777) != 0)
    errno = 0;
  source([&](std::string_view bytes) {
    if (!write_all(file.value(), bytes)) fail_to_write(replaced);
  });
  if (::fsync(file.value()) != 0 || !file.close()) fail_to_write(replaced);
}

/// Brings a rename to the disk. File systems that cannot synchronise a folder have nothing to bring.
void synchronise_folder(const std::filesystem::path& folder) {
  const Descriptor handle(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.value() >= 0 && ::fsync(handle.value()) != 0) errno = 0;
}

}  // namespace

void write_atomically(const std::filesystem::path& path, const ByteSource& source,
                      std::filesystem::path temporary) {
  if (temporary.empty()) temporary = path.string() + "." + std::to_string(::getpid()) + ".tmp";
  try {
    write_durably(temporary, source, path);
    if (::rename(temporary.c_str(), path.c_str()) != 0) fail_to_write(path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  synchronise_folder(path.parent_path());
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes,
                      std::filesystem::path temporary) {
  const ByteSource source = [bytes](const ByteSink& put) { put(bytes); };
  write_atomically(path, source, std::move(temporary));
}

void write_in_place(const std::filesystem::path& path, const ByteSource& source) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
  if (file.value() < 0) fail_to_write(path);
  source([&](std::string_view bytes) {
    if (!write_all(file.value(), bytes)) fail_to_write(path);
  });
}

void move_durably(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  Descriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.value() < 0 || ::fsync(file.value()) != 0 || !file.close() ||
      ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary.c_str());
    throw ResultsError(path.string() + ": cannot write: " + system_reason(reason));
  }
  synchronise_folder(path.parent_path());
}

AppendedFile::AppendedFile(std::filesystem::path path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
  if (descriptor_ < 0) throw ResultsError(path_.string() + ": cannot open: " + system_reason(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  ::close(descriptor_);
  throw ResultsError(path_.string() + ": cannot lock: " + system_reason(reason));
}

AppendedFile::~AppendedFile() { ::close(descriptor_); }

void AppendedFile::append(std::string_view block) {
  {
    const std::scoped_lock lock(mutex_);
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    if (!write_all(descriptor_, block)) {
      const int reason = errno;
      // Where that fails too: half a block is no block to its readers either.
      if (size < 0 || ::ftruncate(descriptor_, size) != 0) errno = 0;
      throw ResultsError(path_.string() + ": cannot write: " + system_reason(reason));
    }
  }
  if (::fdatasync(descriptor_) != 0) fail_to_write(path_);
}

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ResultsError(path.string() + ": cannot open: " + system_reason(errno));
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (file.bad() || bytes.bad()) throw ResultsError(path.string() + ": cannot read: " + system_reason(errno));
  return std::move(bytes).str();
}

std::string system_reason(int error_number) { return std::generic_category().message(error_number); }

}  // namespace raygauge
