// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace raygauge {

/// Replaces `path` by a file of these bytes: written to `temporary` (in the same file system), brought to the
/// disk, renamed. At every moment `path` is its old self or complete. Throws ResultsError with the system's
/// reason; `temporary` is then gone and `path` untouched.
void write_atomically(const std::filesystem::path& path, std::string_view bytes,
                      const std::filesystem::path& temporary);

/// The same with a temporary file beside `path` that no other process uses.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The system's words for an errno value: "No space left on device".
std::string system_reason(int error_number);

}  // namespace raygauge
