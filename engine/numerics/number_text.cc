// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace raygauge {
namespace {

constexpr int kBuffer = 64;

/// Numbers from here up to 10^kMostDigits are written without an exponent.
constexpr double kSmallestPlain = 0.01;
constexpr int kMostDigits = 6;

std::string not_finite(double value) {
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

std::string formatted(const char* format, int digits, double value) {
  std::array<char, kBuffer> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, digits, value);
  return buffer.data();
}

template <class... Format>
std::string to_chars_text(double value, Format... format) {
  std::array<char, kBuffer> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr};
}

bool is_below_plain(double value) { return value != 0 && std::abs(value) < kSmallestPlain; }

}  // namespace

std::string short_exponent(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::string sign = text[e + 1] == '-' ? "-" : "";
  const std::size_t digits = text.find_first_not_of("+-0", e + 1);
  return text.substr(0, e + 1) + sign + (digits == std::string::npos ? "0" : text.substr(digits));
}

std::string shortest_text(double value) {
  if (!std::isfinite(value)) return not_finite(value);
  if (is_below_plain(value)) return short_exponent(to_chars_text(value, std::chars_format::scientific));
  const std::string text = to_chars_text(value);
  // 10^5, which std::to_chars writes shorter with an exponent.
  if (text.find("e+0") != std::string::npos && std::abs(value) < std::pow(10, kMostDigits))
    return to_chars_text(value, std::chars_format::fixed);
  return short_exponent(text);
}

std::string rounded_text(double value, int digits) {
  if (!std::isfinite(value)) return not_finite(value);
  std::string text = formatted("%.*e", digits - 1, value);
  if (!is_below_plain(std::strtod(text.c_str(), nullptr)))
    return short_exponent(formatted("%.*g", digits, value));
  const std::size_t e = text.find('e');
  std::size_t end = text.find('.') == std::string::npos ? e : text.find_last_not_of('0', e - 1) + 1;
  if (text[end - 1] == '.') --end;
  return short_exponent(text.erase(end, e - end));
}

}  // namespace raygauge
