// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge {
namespace {

std::string holder_of(int descriptor) {
  std::array<char, 32> buffer{};
  const ssize_t length = ::pread(descriptor, buffer.data(), buffer.size(), 0);
  return length > 0 ? " (process " + std::string(buffer.data(), static_cast<std::size_t>(length)) + ")" : "";
}

void write_holder(int descriptor) {
  const std::string holder = std::to_string(::getpid());
  // The number only helps the message of another process; on a full disk the lock holds without it.
  if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, holder.data(), holder.size(), 0) < 0) errno = 0;
}

}  // namespace

FileLock::FileLock(std::filesystem::path path) : path_(std::move(path)) {
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw ResultsError(path_.string() + ": cannot create: " + system_reason(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      const std::string holder = holder_of(descriptor_);
      ::close(descriptor_);
      if (reason == EWOULDBLOCK) {
        throw RunLockedError(path_.parent_path().string() + ": another process is writing this run" + holder);
      }
      throw ResultsError(path_.string() + ": cannot lock: " + system_reason(reason));
    }
  } while (!is_current());
  write_holder(descriptor_);
}

void FileLock::require_held() const {
  if (is_current()) return;
  throw RunLockedError(path_.parent_path().string() +
                       ": the lock of this run was lost, another process may be writing it; what is stored "
                       "stays there, --resume goes on with it");
}

FileLock::~FileLock() {
  if (is_current()) ::unlink(path_.c_str());
  ::close(descriptor_);
}

/// Whether the locked file is still the one of that name: its last holder may have removed it between our
/// opening and our locking it.
bool FileLock::is_current() const {
  struct stat named {};
  struct stat locked {};
  return ::stat(path_.c_str(), &named) == 0 && ::fstat(descriptor_, &locked) == 0 &&
         named.st_ino == locked.st_ino && named.st_dev == locked.st_dev;
}

bool is_locked(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

}  // namespace raygauge
