// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/toml_keys.h"

#include <algorithm>

namespace raygauge::cli {
namespace {

/// Where the string ends that begins at `start`, one past its last quote. One that does not end is for the
/// parser to reject; it extends to the end of its line, or of the text if it may have several lines.
std::size_t end_of_string(std::string_view text, std::size_t start) {
  const char quote = text[start];
  const std::string_view long_quote = quote == '"' ? R"(""")" : "'''";
  const bool is_long = text.substr(start, 3) == long_quote;
  const std::string_view end = is_long ? long_quote : long_quote.substr(0, 1);
  for (std::size_t at = start + end.size(); at < text.size(); ++at) {
    if (text.substr(at, end.size()) == end) return at + end.size();
    if (text[at] == '\n' && !is_long) return at;
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return text.size();
}

}  // namespace

std::uint32_t line_of_endless_key(std::string_view text) {
  constexpr std::string_view kEndsOfKeys = "=,[]{}\n";
  std::uint32_t line = 1;
  std::size_t dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t next = at + 1;
    if (c == '"' || c == '\'') next = end_of_string(text, at);
    if (c == '#') next = std::min(text.find('\n', at), text.size());
    if (c == '.' && ++dots >= kMostKeyParts) return line;
    if (kEndsOfKeys.find(c) != std::string_view::npos) dots = 0;
    line += static_cast<std::uint32_t>(std::count(text.begin() + at, text.begin() + next, '\n'));
    at = next;
  }
  return 0;
}

}  // namespace raygauge::cli
