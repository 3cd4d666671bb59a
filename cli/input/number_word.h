// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raygauge::cli {

/// The double that a whole word says: decimal digits, with or without sign, point and exponent, or nan, inf,
/// infinity. Too small for double precision is 0 (or a subnormal number), too large is infinite. Nothing
/// where the word is anything else: hexadecimal digits, a decimal comma, characters behind the number. Every
/// text format reads its numbers here.
std::optional<double> number_of(std::string_view word);

/// A whole word as an integer; nothing where it is none, or too large.
std::optional<long> integer_of(std::string_view word);

/// Why a word that number_of() takes for NaN or infinity cannot be used, with a blank in front.
std::string non_finite_reason(std::string_view word);

/// The word as a message can show it: in quotes, printable, on one line, not endless.
std::string quoted(std::string_view word);

}  // namespace raygauge::cli
