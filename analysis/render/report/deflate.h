// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace raygauge::report {

/// `bytes` in the format of gzip (RFC 1952), the same on every call. Throws Error if zlib fails.
std::string gzip(std::string_view bytes);

/// RFC 4648 base64 with padding.
std::string base64(std::string_view bytes);

}  // namespace raygauge::report
