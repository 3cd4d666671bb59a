// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge {

/// `text` as the content of an element of HTML or XML: & and < are written as entities.
std::string escaped_markup(const std::string& text);

}  // namespace raygauge
