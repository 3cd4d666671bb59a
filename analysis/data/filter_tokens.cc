// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/filter_tokens.h"

#include <array>
#include <cctype>
#include <string_view>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

bool is_word_character(char c) {
  constexpr std::string_view kMarks = "_.+-:/";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || kMarks.find(c) != std::string_view::npos ||
         static_cast<unsigned char>(c) >= 0x80;
}

Token word_at(const std::string& expression, std::size_t begin) {
  std::size_t end = begin;
  while (end < expression.size() && is_word_character(expression[end])) ++end;
  return {TokenKind::word, expression.substr(begin, end - begin), begin};
}

Token quoted_at(const std::string& expression, std::size_t begin) {
  const std::size_t end = expression.find(expression[begin], begin + 1);
  if (end == std::string::npos) {
    throw InvalidParameterError(
        filter_complaint(expression, begin, "the quote that opens here is never closed"));
  }
  return {TokenKind::quoted, expression.substr(begin + 1, end - begin - 1), begin};
}

Token symbol_at(const std::string& expression, std::size_t begin) {
  // Longer ones first.
  constexpr std::array<std::string_view, 11> kSymbols = {
      "&&", "||", "==", "!=", "<=", ">=", "<", ">", "!", "(", ")"};
  for (const std::string_view symbol : kSymbols) {
    if (expression.compare(begin, symbol.size(), symbol) == 0)
      return {TokenKind::symbol, std::string(symbol), begin};
  }
  const std::string found(1, expression[begin]);
  const std::string hint =
      found == "=" || found == "&" || found == "|" ? "; did you mean '" + found + found + "'?" : "";
  throw InvalidParameterError(filter_complaint(expression, begin, "unexpected '" + found + "'" + hint));
}

std::size_t length_of(const Token& token) {
  return token.text.size() + (token.kind == TokenKind::quoted ? 2 : 0);
}

}  // namespace

std::string filter_place(const std::string& expression, std::size_t position) {
  return "filter '" + expression + "', character " + std::to_string(position + 1);
}

std::string filter_complaint(const std::string& expression, std::size_t position, const std::string& what) {
  return filter_place(expression, position) + ": " + what;
}

std::vector<Token> filter_tokens(const std::string& expression) {
  std::vector<Token> tokens;
  std::size_t position = 0;
  while (position < expression.size()) {
    const char c = expression[position];
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++position;
      continue;
    }
    if (c == '\'' || c == '"') {
      tokens.push_back(quoted_at(expression, position));
    } else if (is_word_character(c)) {
      tokens.push_back(word_at(expression, position));
    } else {
      tokens.push_back(symbol_at(expression, position));
    }
    position += length_of(tokens.back());
  }
  tokens.push_back({TokenKind::end, "", expression.size()});
  return tokens;
}

}  // namespace raygauge
