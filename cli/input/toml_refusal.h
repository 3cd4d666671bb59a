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

/// Runs `call`; what it complains of gets the place FILE:LINE, unless it names a place in that file already.
template <class Call>
auto placed(const std::string& place, const Call& call) {
  try {
    return call();
  } catch (const Error& error) {
    const std::string message = error.what();
    const std::string file = place.substr(0, place.rfind(':') + 1);
    const bool has_place = message.starts_with(place + ":") || (!file.empty() && message.starts_with(file));
    throw InvalidParameterError(has_place ? message : place + ": " + message);
  }
}

template <class Call>
auto placed(const toml::node& node, const Call& call) {
  return placed(place_of(node), call);
}

}  // namespace raygauge::cli
