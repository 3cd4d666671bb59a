// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raygauge {

enum class TokenKind : std::uint8_t {
  word,    ///< a name, a number, or a bare text
  quoted,  ///< a text, without its quotes
  symbol,  ///< && || ! ( ) == != < <= > >=
  end,
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;
  std::size_t position = 0;  ///< of its first character in the expression, from 0
};

/// Splits a filter expression; the last token is `end`. Throws InvalidParameterError for a character that
/// begins no token and for a quote that is never closed.
std::vector<Token> filter_tokens(const std::string& expression);

/// "filter 'EXPRESSION', character 3" (characters counted from 1).
std::string filter_place(const std::string& expression, std::size_t position);

/// filter_place(), a colon, and what is wrong there.
std::string filter_complaint(const std::string& expression, std::size_t position, const std::string& what);

}  // namespace raygauge
