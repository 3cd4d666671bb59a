// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/input_options.h"

#include "cli/input/input_file.h"

namespace raygauge::cli {

void add_max_input_option(Command& command) {
  command
      .add_option_function("--max-input", limit_compressed_input,
                           "Largest size of a compressed input once it is decompressed, in MiB; default: " +
                               std::to_string(kMaxInput))
      .type_name("MIB");
}

}  // namespace raygauge::cli
