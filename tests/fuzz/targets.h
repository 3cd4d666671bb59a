// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raygauge::fuzz {

struct Target {
  std::string name;
  void (*check)(std::string_view input);
  bool is_reader = true;  ///< reads a file of the user's: small inputs take little memory and time
};

/// Every fuzz target.
const std::vector<Target>& targets();

}  // namespace raygauge::fuzz
