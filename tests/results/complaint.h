// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::testing {

/// What a call is refused with, without the folder; empty where nothing is thrown.
template <class Call>
std::string complaint_of(const TemporaryFolder& place, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    std::string message = error.what();
    const std::string folder = place.path() + "/";
    for (std::size_t at; (at = message.find(folder)) != std::string::npos;) message.erase(at, folder.size());
    return message;
  }
  return "";
}

}  // namespace raygauge::testing
