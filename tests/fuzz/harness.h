// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/exceptions.h"

/// Defined once in each fuzz target; called by libFuzzer, and by the replay of frozen inputs. What escapes it
/// is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace raygauge::fuzz {

/// A promise of the library that an input broke.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& promise) {
  if (!holds) throw BrokenPromise(promise);
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs `call`. It may succeed or throw Error with a message; everything else is a finding.
template <class Call>
void expect_success_or_error(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    require(!std::string_view(error.what()).empty(), "an error says why");
  }
}

}  // namespace raygauge::fuzz
