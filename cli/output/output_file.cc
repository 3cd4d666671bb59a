// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/output_file.h"

#include <cstdio>

namespace raygauge::cli {

void add_force_option(Command& command, bool& force) {
  command.add_flag("--force", force,
                   "Replace an existing file of another kind; never measurements, never an input");
}

void write_to(const OutputRequest& request, const std::string& bytes) {
  const OutputPlace place = output_place(request);
  if (place.way == OutputWay::standard_output) {
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  } else {
    write_output(place, bytes);
  }
}

void print_path(const OutputRequest& request) {
  if (output_place(request).way == OutputWay::file) std::printf("%s\n", request.path.c_str());
}

}  // namespace raygauge::cli
