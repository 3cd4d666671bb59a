// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/number_word.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <system_error>

namespace raygauge::cli {
namespace {

/// from_chars takes no plus sign.
std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  word = without_plus(word);
  const char* const end = word.data() + word.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  // Out of range is overflow or underflow; strtod tells which.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

std::optional<long> integer_of(std::string_view word) {
  word = without_plus(word);
  const char* const end = word.data() + word.size();
  long value = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string non_finite_reason(std::string_view word) {
  const bool is_overflow = word.find_first_of("0123456789") != std::string_view::npos;
  return is_overflow ? " is too large for double precision" : " is not a finite number";
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return "'" + text + (word.size() > kLongest ? "…'" : "'");
}

}  // namespace raygauge::cli
