// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace raygauge::cli {

/// Whether a person is reading the stream.
bool is_terminal(std::FILE* stream);

/// Whether to write colours to the stream: a person reads it, and NO_COLOR (https://no-color.org) is not set.
bool wants_color(std::FILE* stream);

/// Columns of the terminal on the stream; 0 where it is none or does not tell.
std::size_t terminal_width(std::FILE* stream);

/// `text` in bold red on a terminal; as it is elsewhere, or with NO_COLOR set (https://no-color.org).
std::string alarming(const std::string& text, std::FILE* stream);

/// "0.4 s", "16 s", "3 min 20 s", "1 h 05 min": a duration as one says it.
std::string duration_text(double seconds);

}  // namespace raygauge::cli
