// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/output_place.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <optional>
#include <system_error>

#include "results/disk/run_directory.h"
#include "results/hdf5/hdf5_library.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPartsSuffix = ".parts";

[[noreturn]] void refuse(const OutputRequest& request, const std::string& reason) {
  throw OutputRefusedError(request.path + ": " + reason);
}

/// What stat() says of what is at the end of all links; nothing where nothing is there.
std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

bool is_same_file(const struct stat& status, const fs::path& other) {
  const auto other_status = status_of(other);
  return other_status && other_status->st_dev == status.st_dev && other_status->st_ino == status.st_ino;
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool has_name_of_results(const fs::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".h5" || extension == ".hdf5";
}

/// Whether the links of `path` pass through /proc: the name of an open file, as /dev/stdout is one.
bool names_an_open_file(const fs::path& path) {
  fs::path at = path;
  std::error_code error;
  for (int links = 0; links < 40; ++links) {
    const fs::path folder = fs::weakly_canonical(at.has_parent_path() ? at.parent_path() : ".", error);
    if (folder.string().starts_with("/proc/")) return true;
    const fs::path target = fs::read_symlink(at, error);
    if (error) return false;
    at = at.parent_path() / target;
  }
  return false;
}

void refuse_inputs(const OutputRequest& request, const struct stat& status) {
  for (const std::string& input : request.inputs) {
    if (is_same_file(status, input)) refuse(request, "is an input of this command; nothing was written");
  }
}

/// The folder of parts may lie beside a file that is not there yet: its name says enough.
void refuse_parts(const OutputRequest& request, const fs::path& file) {
  const std::string folder = fs::absolute(file).parent_path().string();
  if (!folder.ends_with(kPartsSuffix)) return;
  if (list_parts(folder.substr(0, folder.size() - kPartsSuffix.size())).empty()) return;
  refuse(request, "lies among the cells of an unfinished run; nothing was written");
}

/// Whether `path` holds measurements: whatever its name is.
bool holds_hdf5(const fs::path& path) {
  try {
    hdf5::require_hdf5(path);
    return true;
  } catch (const ResultsError&) {
    return false;
  }
}

void refuse_replacing(const OutputRequest& request, const fs::path& file, const struct stat& status) {
  if (holds_hdf5(file)) {
    refuse(request, "holds HDF5 data, which nothing derived replaces; nothing was written");
  }
  if (request.force || status.st_size == 0) return;
  const auto& known = request.extensions;
  if (std::find(known.begin(), known.end(), extension_of(file)) == known.end()) {
    refuse(request, "exists, and is no earlier output of this kind" +
                        (known.empty() ? "" : " (" + known.front() + ")") + "; --force replaces it");
  }
  if (::access(file.c_str(), W_OK) != 0) refuse(request, "is write-protected; --force replaces it");
}

OutputPlace place_in_file(const OutputRequest& request, const std::optional<struct stat>& status) {
  const fs::path file = behind_links(request.path);
  if (!file.has_filename()) refuse(request, "is the name of a folder, not of a file");
  refuse_parts(request, file);
  if (request.kind == OutputKind::results) return {OutputWay::file, file};
  if (has_name_of_results(file) || has_name_of_results(request.path)) {
    refuse(request,
           "is a name of measurements" +
               (request.extensions.empty() ? "" : "; name a file ending in " + request.extensions.front()));
  }
  if (status) refuse_replacing(request, file, *status);
  return {OutputWay::file, file};
}

OutputPlace place_in_stream(const OutputRequest& request) {
  if (request.kind == OutputKind::results) {
    refuse(request, "is no regular file, and a run keeps its cells beside its results file");
  }
  return {OutputWay::stream, request.path};
}

}  // namespace

fs::path behind_links(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as Linux itself
  fs::path at = path;
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(at, error))) return at;
    // A relative target starts at the folder of the link.
    at = at.parent_path() / fs::read_symlink(at, error);
    if (error) break;
  }
  throw OutputRefusedError(path.string() + ": its links cannot be followed");
}

OutputPlace output_place(const OutputRequest& request) {
  if (request.path.empty()) throw OutputRefusedError("the name of an output is empty");
  if (request.path == "-") {
    if (request.kind == OutputKind::text) return {OutputWay::standard_output, {}};
    refuse(request, "standard output takes text; name a file");
  }
  const auto status = status_of(request.path);
  if (!status) return place_in_file(request, status);
  refuse_inputs(request, *status);
  if (S_ISDIR(status->st_mode)) refuse(request, "is a folder, not a file");
  if (S_ISSOCK(status->st_mode)) refuse(request, "is a socket; nothing was written");
  if (S_ISBLK(status->st_mode) && !request.force) refuse(request, "is a disk; --force writes to it");
  if (!S_ISREG(status->st_mode)) return place_in_stream(request);
  if (!names_an_open_file(request.path)) return place_in_file(request, status);
  if (holds_hdf5(request.path)) refuse(request, "holds HDF5 data; nothing was written");
  return place_in_stream(request);
}

void write_output(const OutputPlace& place, const ByteSource& source) {
  if (place.way == OutputWay::stream) return write_in_place(place.path, source);
  const fs::path folder = place.path.parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw ResultsError(folder.string() + ": cannot create the folder: " + error.message());
  write_atomically(place.path, source);
}

void write_output(const OutputPlace& place, std::string_view bytes) {
  write_output(place, [bytes](const ByteSink& put) { put(bytes); });
}

}  // namespace raygauge
