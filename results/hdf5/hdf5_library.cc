// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/hdf5_library.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"
#include "results/hdf5/checksum.h"
#include "results/hdf5/global_heap.h"
#include "results/hdf5/trial.h"

namespace raygauge::hdf5 {
namespace {

constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
constexpr std::size_t kImageIncrement = 65536;
constexpr const char* kDamaged = ": truncated or damaged: ";

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// While it lives, HDF5 reports its errors here instead of printing them. Nor does it print afterwards: at
/// the end of the process it may complain of what a damaged file has left open.
class ErrorCapture {
 public:
  ErrorCapture() { H5Eset_auto2(H5E_DEFAULT, &ErrorCapture::on_error, this); }
  ~ErrorCapture() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }
  ErrorCapture(const ErrorCapture&) = delete;
  ErrorCapture& operator=(const ErrorCapture&) = delete;

  /// The innermost description of the first error.
  const std::string& reason() const noexcept { return reason_; }

 private:
  static herr_t on_error(hid_t stack, void* self) {
    return H5Ewalk2(stack, H5E_WALK_UPWARD, &ErrorCapture::on_level, self);
  }

  static herr_t on_level(unsigned level, const H5E_error2_t* error, void* self) {
    auto& reason = static_cast<ErrorCapture*>(self)->reason_;
    if (level == 0 && reason.empty() && error->desc != nullptr) reason = error->desc;
    return 0;
  }

  std::string reason_;
};

}  // namespace

void locked(const std::string& place, const std::string& failure, const std::function<void()>& body) {
  const std::scoped_lock lock(library_mutex());
  const ErrorCapture capture;
  try {
    body();
  } catch (const H5::Exception& error) {
    const std::string reason = capture.reason().empty() ? error.getDetailMsg() : capture.reason();
    throw ResultsError(place + ": " + failure + ": " + reason);
  } catch (const std::bad_alloc&) {
    throw ResultsError(place + ": does not fit into memory");
  } catch (const std::length_error&) {
    throw ResultsError(place + ": does not fit into memory");
  }
}

std::string file_image(const std::function<void(H5::Group&)>& fill) {
  std::string image;
  locked("file image", "HDF5 could not build it", [&] {
    H5::FileAccPropList in_memory;
    in_memory.setCore(kImageIncrement, false);
    H5::H5File file("raygauge-image", H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
    {
      H5::Group root = file.openGroup("/");
      fill(root);
    }
    file.flush(H5F_SCOPE_GLOBAL);
    const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
    image.reserve(static_cast<std::size_t>(std::max<ssize_t>(size, 0)) + checksum_line("").size());
    image.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    if (size <= 0 || H5Fget_file_image(file.getId(), image.data(), image.size()) != size) {
      throw ResultsError("file image: HDF5 gave none");
    }
  });
  image += checksum_line(image);
  return image;
}

void require_hdf5(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw ResultsError(path.string() + ": no such file");
  }
  if (status.type() == std::filesystem::file_type::directory) {
    throw ResultsError(path.string() + ": a folder, not a file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ResultsError(path.string() + ": cannot open: " + system_reason(errno));
  std::array<char, kSignature.size()> head{};
  file.read(head.data(), head.size());
  if (std::string_view(head.data(), static_cast<std::size_t>(file.gcount())) != kSignature) {
    throw ResultsError(path.string() + ": not an HDF5 file");
  }
}

namespace {

/// Which file it is, and which content of it: a file is written anew under another inode, or with another
/// time.
struct FileState {
  dev_t device = 0;
  ino_t inode = 0;
  off_t size = -1;
  std::int64_t seconds = 0;
  std::int64_t nanoseconds = 0;
  bool operator==(const FileState&) const = default;
};

FileState state_of(const std::filesystem::path& path) {
  struct ::stat status = {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

/// checksum_of(), of the file that was asked for last only once: a command first asks what a file is, and
/// then reads it.
Checksum checksum_once(const std::filesystem::path& path) {
  static std::mutex mutex;
  static FileState last;
  static Checksum of_last = Checksum::none;
  const std::scoped_lock lock(mutex);
  const FileState before = state_of(path);
  if (before.size >= 0 && before == last) return of_last;
  const Checksum checksum = checksum_of(path);
  if (before == state_of(path)) {
    last = before;
    of_last = checksum;
  }
  return checksum;
}

Checksum checked(const std::filesystem::path& path) {
  require_hdf5(path);
  const Checksum checksum = checksum_once(path);
  if (checksum == Checksum::wrong) throw ResultsError(path.string() + kDamaged + "its checksum is wrong");
  return checksum;
}

/// Of a file without a checksum: far more than it takes, and an end where HDF5 would never come to one.
double seconds_to_read(const std::filesystem::path& path) {
  constexpr double kLeast = 5, kBytesPerSecond = 2e6;
  return kLeast + static_cast<double>(std::filesystem::file_size(path)) / kBytesPerSecond;
}

/// Beyond the end that HDF5 knows.
bool has_bytes_beyond_end(const H5::Group& root, const std::filesystem::path& path) {
  const hid_t file = H5Iget_file_id(root.getId());
  haddr_t end = 0;
  const bool known = H5Fget_eoa(file, &end) >= 0;
  H5Fclose(file);
  return !known || std::filesystem::file_size(path) > end;
}

void read_as(const std::filesystem::path& path, Checksum checksum,
             const std::function<void(H5::Group&)>& body) {
  const auto read = [&] {
    H5::H5File file(path.string(), H5F_ACC_RDONLY);
    H5::Group root = file.openGroup("/");
    body(root);
  };
  locked(path.string(), "truncated or damaged", [&] {
    if (checksum == Checksum::none && !survives(read, seconds_to_read(path)))
      throw ResultsError(path.string() + kDamaged + "HDF5 itself fails to read it");
    read();
  });
}

}  // namespace

bool read_file(const std::filesystem::path& path, const std::function<void(H5::Group&)>& body) {
  const Checksum checksum = checked(path);
  read_as(path, checksum, body);
  return checksum == Checksum::right;
}

bool read_own_file(const std::filesystem::path& path, const std::function<void(H5::Group&)>& body) {
  const Checksum checksum = checked(path);
  if (checksum == Checksum::none && has_damaged_global_heap(file_bytes(path)))
    throw ResultsError(path.string() + kDamaged + "a text does not lie within its heap");
  read_as(path, checksum, [&](H5::Group& root) {
    if (checksum == Checksum::none && root.attrExists(kChecksumAttribute) && has_bytes_beyond_end(root, path))
      throw ResultsError(path.string() + kDamaged + "its checksum is none");
    body(root);
  });
  return checksum == Checksum::right;
}

}  // namespace raygauge::hdf5
