// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/output_file.h"

#include <cstdio>
#include <string_view>

namespace raygauge::cli {

void add_force_option(Command& command, bool& force) {
  command.add_flag("--force", force,
                   "Replace an existing file of another kind; never measurements, never an input");
}

Output decided(const OutputRequest& request) { return {request.path, output_place(request)}; }

void write_to(const Output& output, const ByteSource& source) {
  if (output.place.way == OutputWay::standard_output) {
    source([](std::string_view bytes) { std::fwrite(bytes.data(), 1, bytes.size(), stdout); });
  } else {
    write_output(output.place, source);
  }
}

void write_to(const Output& output, const std::string& bytes) {
  write_to(output, [&bytes](const ByteSink& put) { put(bytes); });
}

void print_path(const Output& output) {
  if (output.place.way == OutputWay::file) std::printf("%s\n", output.path.c_str());
}

void write_all(const std::vector<Written>& outputs) {
  for (const Written& each : outputs) {
    write_to(each.output, each.bytes);
    print_path(each.output);
  }
}

}  // namespace raygauge::cli
