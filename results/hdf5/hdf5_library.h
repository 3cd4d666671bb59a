// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <filesystem>
#include <functional>
#include <string>

namespace raygauge::hdf5 {

/// Runs `body` with the HDF5 library to itself: its C++ layer is not thread safe. HDF5 prints nothing
/// meanwhile; an error of its becomes ResultsError("PLACE: FAILURE: REASON") with HDF5's innermost reason.
void locked(const std::string& place, const std::string& failure, const std::function<void()>& body);

/// The bytes of an HDF5 file with the content that `fill` writes and its checksum, built in memory: what can
/// fail on a disk is left to our own writing, which reports it better, and the lock is not held over it.
std::string file_image(const std::function<void(H5::Group&)>& fill);

/// Opens an existing file for reading and hands its root group to `body`; whether it has its checksum
/// (checksum.h). Without one `body` is tried in a process of its own first, so that it must start no threads
/// (trial.h): HDF5 1.10 crashes on some damaged files. Throws ResultsError: missing, not HDF5, truncated or
/// damaged.
bool read_file(const std::filesystem::path& path, const std::function<void(H5::Group&)>& body);

/// The same for a file that raygauge wrote, which is refused where it says that it has a checksum and
/// something else is in its place.
bool read_own_file(const std::filesystem::path& path, const std::function<void(H5::Group&)>& body);

/// Throws ResultsError unless `path` is a regular file that begins as an HDF5 file does.
void require_hdf5(const std::filesystem::path& path);

}  // namespace raygauge::hdf5
