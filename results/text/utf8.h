// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace raygauge::utf8 {

/// The bytes of the character that a text, which is not empty, begins with; none where they are not UTF-8
/// (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
std::string_view first_character(std::string_view text) noexcept;

/// Of a character: whether it is a control character beyond ASCII, ends a line, turns the direction of
/// writing, or is none at all (U+0080 to U+009F, U+2028 to U+202E, U+2066 to U+2069, U+FFFE and U+FFFF).
bool is_unseen(std::string_view character) noexcept;

}  // namespace raygauge::utf8
