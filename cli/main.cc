// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "cli/commands.h"

int main(int argc, char** argv) {
  CLI::App app{"raygauge: by how much must the convex set Q be scaled until it touches the convex set A?",
               "raygauge"};
  app.set_version_flag("--version", std::string("raygauge " RAYGAUGE_VERSION));
  app.require_subcommand(1);
  app.option_defaults()->always_capture_default();
  int status = raygauge::cli::kAnswered;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? raygauge::cli::kAnswered : raygauge::cli::kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raygauge: %s\n", error.what());
    return raygauge::cli::kBadInput;
  }
  return status;
}
