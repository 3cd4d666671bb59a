// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace raygauge {
namespace {

constexpr int kBuffer = 64;

std::string not_finite(double value) {
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

/// "1.2e-07" → "1.2e-7".
std::string short_exponent(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::string sign = text[e + 1] == '-' ? "-" : "";
  const std::size_t digits = text.find_first_not_of("+-0", e + 1);
  return text.substr(0, e + 1) + sign + (digits == std::string::npos ? "0" : text.substr(digits));
}

std::string formatted(const char* format, int digits, double value) {
  std::array<char, kBuffer> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, digits, value);
  return buffer.data();
}

/// Decimal exponent of `value` after rounding to `digits`.
int exponent_of(double value, int digits) {
  const std::string text = formatted("%.*e", digits - 1, value);
  return std::stoi(text.substr(text.find('e') + 1));
}

}  // namespace

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return not_finite(value);
  return short_exponent(formatted("%.*g", digits, value));
}

std::string padded_significant(double value, int digits) {
  if (!std::isfinite(value)) return not_finite(value);
  if (value == 0) return "0";
  constexpr int kSmallest = -5;
  constexpr int kLargest = 7;
  const int exponent = exponent_of(value, digits);
  if (exponent < kSmallest || exponent >= kLargest)
    return short_exponent(formatted("%.*e", digits - 1, value));
  return formatted("%.*f", std::max(0, digits - 1 - exponent), value);
}

std::string interval_words(double value, double lower, double upper) {
  constexpr int kShown = 3;
  return padded_significant(value, kShown) + " [" + padded_significant(lower, kShown) + ", " +
         padded_significant(upper, kShown) + "]";
}

std::string round_trip(double value) {
  if (!std::isfinite(value)) return not_finite(value);
  std::array<char, kBuffer> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace raygauge
