// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

namespace raygauge::cli {

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

bool wants_color(std::FILE* stream) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody here changes the environment
  const char* no_color = std::getenv("NO_COLOR");
  return is_terminal(stream) && (no_color == nullptr || *no_color == '\0');
}

std::size_t terminal_width(std::FILE* stream) {
  winsize size{};
  if (!is_terminal(stream) || ioctl(fileno(stream), TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

std::string alarming(const std::string& text, std::FILE* stream) {
  if (!wants_color(stream)) return text;
  return "\033[1;31m" + text + "\033[0m";
}

std::string duration_text(double seconds) {
  constexpr int kLength = 64;
  char text[kLength];
  if (seconds < 9.95) {
    std::snprintf(text, kLength, "%.1f s", seconds);
    return text;
  }
  const long whole = std::lround(seconds);
  if (whole < 60) {
    std::snprintf(text, kLength, "%ld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, kLength, "%ld min %02ld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, kLength, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
  }
  return text;
}

}  // namespace raygauge::cli
