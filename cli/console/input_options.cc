// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/console/input_options.h"

#include <cstdio>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {

void add_max_input_option(Command& command) {
  command
      .add_option_function("--max-input", limit_compressed_input,
                           "Largest size of a compressed input once it is decompressed, in MiB; default: " +
                               std::to_string(kMaxInput))
      .type_name("MIB");
}

Shard shard_from(const std::string& text) {
  Shard shard{0, 0};
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &shard.index, &shard.count, &rest) != 2 || shard.index < 1 ||
      shard.index > shard.count) {
    throw InvalidParameterError("--shard takes I/K with 1 <= I <= K, as in 3/7; got '" + text + "'");
  }
  return shard;
}

}  // namespace raygauge::cli
