// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <utility>

#include "results/text/language.h"
#include "results/text/utf8.h"

namespace raygauge::language {
namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

constexpr std::array<Replacement, 40> kReplacements = {{
    {"\\", "\\textbackslash{}"},
    {"&", "\\&"},
    {"%", "\\%"},
    {"$", "\\$"},
    {"#", "\\#"},
    {"_", "\\_"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"~", "\\textasciitilde{}"},
    {"^", "\\textasciicircum{}"},
    {"<", "\\textless{}"},
    {">", "\\textgreater{}"},
    {"|", "\\textbar{}"},
    {"\"", "''"},
    {"ε", "$\\varepsilon$"},
    {"µ", "$\\mu$"},  // micro sign
    {"μ", "$\\mu$"},  // Greek letter
    {"σ", "$\\sigma$"},
    {"η", "$\\eta$"},
    {"λ", "$\\lambda$"},
    {"α", "$\\alpha$"},
    {"β", "$\\beta$"},
    {"δ", "$\\delta$"},
    {"τ", "$\\tau$"},
    {"≤", "$\\le$"},
    {"≥", "$\\ge$"},
    {"×", "$\\times$"},
    {"·", "$\\cdot$"},
    {"±", "$\\pm$"},
    {"∞", "$\\infty$"},
    {"√", "$\\surd$"},
    {"…", "\\ldots{}"},
    {"–", "--"},
    {"—", "---"},
    {"†", "$\\dagger$"},
    {"−", "$-$"},
    {"[", "{[}"},  // after the end of a row it would begin an option
    {"]", "{]}"},
    {"*", "{*}"},
    {"`", "\\textasciigrave{}"},
}};

/// "\\x0A" as LaTeX shows it.
std::string shown_by_number(char c) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "\\textbackslash{}x%02X", static_cast<unsigned char>(c));
  return text.data();
}

std::string shown(std::string_view character) {
  for (const Replacement& replacement : kReplacements)
    if (character == replacement.first) return std::string(replacement.second);
  std::string text;
  const bool plain = static_cast<unsigned char>(character.front()) >= 0x20 && character.front() != '\x7F';
  if (plain && !utf8::is_unseen(character)) return std::string(character);
  for (const char c : character) text += shown_by_number(c);
  return text;
}

}  // namespace

std::string latex(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view character = utf8::first_character(text);
    result += character.empty() ? shown_by_number(text.front()) : shown(character);
    text.remove_prefix(character.empty() ? 1 : character.size());
  }
  return result;
}

}  // namespace raygauge::language
