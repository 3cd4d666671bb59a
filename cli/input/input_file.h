// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge::cli {

/// The name that stands for standard input.
inline constexpr const char* kStandardInput = "-";

/// All bytes of a file, or of standard input for "-". Throws InvalidParameterError with the system's reason:
/// the file is missing, a directory, not readable.
std::string read_input(const std::string& path);

/// How messages call the input: its path, or "standard input".
std::string input_name(const std::string& path);

}  // namespace raygauge::cli
