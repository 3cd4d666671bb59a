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
    std::string message = error.what();
    const std::string file = place.substr(0, place.rfind(':') + 1);
    if (file.empty() || !message.starts_with(file)) throw InvalidParameterError(place + ": " + message);
    message.erase(0, file.size());
    const bool has_line = message.find_first_of("0123456789") == 0;
    throw InvalidParameterError(has_line ? file + message : place + ":" + message);
  }
}

template <class Call>
auto placed(const toml::node& node, const Call& call) {
  return placed(place_of(node), call);
}

}  // namespace raygauge::cli
