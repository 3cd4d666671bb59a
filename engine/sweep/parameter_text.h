// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raygauge {

/// A text as the value of NAME=VALUE: in double quotes if it holds a blank, a quote, a backslash or a control
/// character; there `\"`, `\\`, `\n`, `\r` and `\t` stand for themselves.
std::string quoted_where_needed(const std::string& text);

/// The inverse of to_string(Parameters): names and values in their order, without quotes. Words without "="
/// belong to the value before them.
std::vector<std::pair<std::string, std::string>> split_parameters(const std::string& text);

}  // namespace raygauge
