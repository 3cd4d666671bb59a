// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace raygauge::hdf5 {

// Each HDF5 file that raygauge writes ends in a line of text, "raygauge CRC-32 1a2b3c4d": zlib's checksum of
// all bytes before it. HDF5 does not look there, and takes the line away where another program changes the
// file. The root's attribute `checksum` stays: it says that what lies beyond the end that HDF5 knows has to
// be that line.

inline constexpr const char* kChecksumAttribute = "checksum";
inline constexpr const char* kChecksumMeaning = "the last 25 bytes: CRC-32 of all bytes before them";

enum class Checksum : std::uint8_t { none, right, wrong };

/// The last line of a file that begins with `bytes`.
std::string checksum_line(std::string_view bytes);

/// Adds the line to a file. Throws ResultsError.
void append_checksum(const std::filesystem::path& path);

/// What the end of a file says of it. Throws ResultsError where the file cannot be read.
Checksum checksum_of(const std::filesystem::path& path);

}  // namespace raygauge::hdf5
