// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/text/number_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/numerics/number_text.h"

namespace raygauge {
namespace {

std::string formatted(const char* format, int digits, double value) {
  constexpr int kBuffer = 64;
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

std::string padded_significant(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return shortest_text(value);
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

}  // namespace raygauge
