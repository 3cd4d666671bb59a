// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "cli/input/set_file.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

/// The set that a set file of this text describes. Files that it names are not read: a fuzzer would find
/// devices.
inline cli::SetPointer set_of(std::string_view text) {
  static const ScratchFile file(".toml");
  file.write(text);
  return cli::read_set_file(file.path(), [](const std::string&) -> cli::SetPointer {
    throw InvalidParameterError("a fuzzer reads no other files");
  });
}

}  // namespace raygauge::fuzz
