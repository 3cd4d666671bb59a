// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace raygauge::bench {

/// What main() returns: the status of run(argc, argv), or 2 after an error, which is a line on standard
/// error.
inline int run_program(const char* name, int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 2;
  }
}

/// The same for a program that reads its options into a Settings, which options(app, settings) declares, and
/// does all else in run(settings).
template <class Settings>
int run_with_options(const char* name, const char* description, void (*options)(CLI::App&, Settings&),
                     void (*run)(const Settings&), int argc, char** argv) {
  try {
    Settings settings;
    CLI::App app{description};
    app.option_defaults()->always_capture_default();
    options(app, settings);
    CLI11_PARSE(app, argc, argv);
    run(settings);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 2;
  }
}

}  // namespace raygauge::bench
