// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace raygauge {

/// The words, `separator` between them: "a, b".
template <class Words>
std::string joined(const Words& words, const std::string& separator = ", ") {
  std::string text;
  bool first = true;
  for (const auto& word : words) {
    if (!first) text += separator;
    text += word;
    first = false;
  }
  return text;
}

/// "a, b, c, 2 more": of many entries those beyond the first 12 are counted.
inline std::string listed(const std::vector<std::string>& entries, const std::string& separator) {
  constexpr std::size_t kMostNamed = 12;
  if (entries.size() <= kMostNamed) return joined(entries, separator);
  const std::vector<std::string> named(entries.begin(), entries.begin() + kMostNamed);
  return joined(named, separator) + separator + std::to_string(entries.size() - kMostNamed) + " more";
}

/// "1 body", "2 bodies".
template <class Integer>
std::string counted(Integer number, const std::string& one, const std::string& several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

/// "1 cell", "2 cells".
template <class Integer>
std::string counted(Integer number, const std::string& one) {
  return counted(number, one, one + "s");
}

}  // namespace raygauge
