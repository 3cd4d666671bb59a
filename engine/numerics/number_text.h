// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge {

/// The digits that read back as the same double, and no more, as every number is shown: "0.25", "5e-3",
/// "1e-8", "100000", "1e6", "inf", "nan". Below 0.01 with an exponent, which has neither plus nor zeros.
std::string shortest_text(double value);

/// `value` with at most `digits` significant digits, written in the same way: "0.25", "1e-6", "12300".
std::string rounded_text(double value, int digits);

/// "1.2e-07" becomes "1.2e-7".
std::string short_exponent(const std::string& text);

}  // namespace raygauge
