// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace raygauge::cli {

/// "1 body", "2 bodies".
template <class Integer>
std::string counted(Integer number, const std::string& one, const std::string& several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

/// "1 point", "2 points".
template <class Integer>
std::string counted(Integer number, const std::string& one) {
  return counted(number, one, one + "s");
}

/// "a, b, c, 2 more": of many entries those beyond the first 12 are counted.
inline std::string listed(const std::vector<std::string>& entries, const std::string& separator) {
  constexpr std::size_t kMostNamed = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(entries.size(), kMostNamed); ++i)
    text += (text.empty() ? "" : separator) + entries[i];
  if (entries.size() > kMostNamed) text += separator + std::to_string(entries.size() - kMostNamed) + " more";
  return text;
}

}  // namespace raygauge::cli
