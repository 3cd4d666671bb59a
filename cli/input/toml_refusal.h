// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/input/toml_source.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {

/// Throws InvalidParameterError "FILE:LINE: what".
[[noreturn]] inline void refuse(const toml::node& node, const std::string& what) {
  throw InvalidParameterError(place_of(node) + ": " + what);
}

/// Runs `call`; what the engine complains of gets the node's place.
template <class Call>
auto placed(const toml::node& node, const Call& call) {
  try {
    return call();
  } catch (const Error& error) {
    refuse(node, error.what());
  }
}

}  // namespace raygauge::cli
