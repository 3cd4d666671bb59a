// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace raygauge::cli {

/// One line that says what is wrong with the command line that `app` has just refused: an unknown command or
/// option with the nearest known one, or the parser's own complaint, and where help is.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

/// `text` without line breaks, as an error message must be.
std::string on_one_line(std::string text);

}  // namespace raygauge::cli
