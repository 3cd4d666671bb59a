// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

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

}  // namespace raygauge::cli
