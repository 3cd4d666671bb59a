// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace raygauge::cli {

/// An object whose members keep the order in which they were set.
using Json = nlohmann::ordered_json;

/// The value on one line. Real numbers have 17 significant digits, so that reading them gives the same
/// double; infinities are the strings "inf" and "-inf", NaN (a value that was not computed) is null.
std::string json_text(const Json& value);

}  // namespace raygauge::cli
