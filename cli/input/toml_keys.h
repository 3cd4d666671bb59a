// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raygauge::cli {

/// The most parts that a dotted key may have, as a.b.c has three. toml++ bounds how deep values are nested,
/// but up to version 3.3 not how deep keys go: it overflows the stack over some ten thousand parts.
inline constexpr std::size_t kMostKeyParts = 32;

/// The number, from 1, of the first line of a TOML text with a key of more parts than that; 0 if there is
/// none. Dots in strings and comments do not count.
std::uint32_t line_of_endless_key(std::string_view text);

}  // namespace raygauge::cli
