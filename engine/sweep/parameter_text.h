// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raygauge/sweep/registry.h"

namespace raygauge {

/// A text as the value of NAME=VALUE: in double quotes if it holds a blank, a quote, a backslash or a control
/// character; there `\"`, `\\`, `\n`, `\r` and `\t` stand for themselves.
std::string quoted_where_needed(const std::string& text);

/// The inverse of to_string(Parameters): names and values in their order, without quotes. Words without "="
/// belong to the value before them.
std::vector<std::pair<std::string, std::string>> split_parameters(const std::string& text);

/// The parameters of such a text, each of its declared type. Throws UnknownNameError for one that is not
/// declared, InvalidParameterError for a value that is not of its type.
Parameters parameters_from(const std::string& text, const std::vector<ParameterInfo>& declared);

}  // namespace raygauge
