// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/text/utf8.h"

#include <cstddef>
#include <cstdint>

namespace raygauge::utf8 {
namespace {

std::uint32_t byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Of a character that begins with the byte `head`; 0: none does.
std::size_t length_by(std::uint32_t head) {
  if (head < 0x80) return 1;
  if (head < 0xC2) return 0;
  if (head < 0xE0) return 2;
  if (head < 0xF0) return 3;
  return head < 0xF5 ? 4 : 0;
}

std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return byte(character, 0);
  std::uint32_t code = byte(character, 0) & (0x7FU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte(character, i) & 0x3FU);
  return code;
}

}  // namespace

std::string_view first_character(std::string_view text) noexcept {
  const std::size_t length = length_by(byte(text, 0));
  if (length == 0 || length > text.size()) return {};
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text, i) & 0xC0U) != 0x80U) return {};
  }
  const std::uint32_t code = code_point(text.substr(0, length));
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  if (overlong || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return text.substr(0, length);
}

bool is_unseen(std::string_view character) noexcept {
  const std::uint32_t code = code_point(character);
  const auto within = [code](std::uint32_t low, std::uint32_t high) { return code >= low && code <= high; };
  return within(0x80, 0x9F) || within(0x2028, 0x202E) || within(0x2066, 0x2069) || within(0xFFFE, 0xFFFF);
}

}  // namespace raygauge::utf8
