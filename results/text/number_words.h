// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge {

/// `value` with exactly `digits` significant digits as long as that is no more than 4 places of zeros:
/// "0.0120", "1.36", "123", "1.2e-7"; "inf", "nan".
std::string padded_significant(double value, int digits);

/// "1.23 [1.20, 1.26]": a value and the ends of its interval, 3 digits.
std::string interval_words(double value, double lower, double upper);

}  // namespace raygauge
