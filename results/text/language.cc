// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/text/language.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

#include "raygauge/exceptions.h"
#include "results/text/utf8.h"

namespace raygauge::language {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD
constexpr char kDelete = '\x7F';

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == kDelete; }

/// U+2400 and what follows: ␀, ␁, … for the control characters, ␡ for DEL.
std::string picture(char control) {
  const int offset = control == kDelete ? 0x21 : static_cast<unsigned char>(control);
  return std::string("\xE2\x90") + static_cast<char>(0x80 + offset);
}

/// "\\012": the byte in bash and in gnuplot.
std::string by_number(char c) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "\\%03o", static_cast<unsigned char>(c));
  return text.data();
}

/// `text` by printable(), with `mark` before each ASCII character of `special`.
std::string marked(std::string_view text, std::string_view special, char mark) {
  std::string result;
  for (const char c : printable(text)) {
    if (special.find(c) != std::string_view::npos) result += mark;
    result += c;
  }
  return result;
}

/// A character as HTML, SVG and XML write it.
std::string entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return std::string(1, c);
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view character = utf8::first_character(text);
    if (character.empty() || utf8::is_unseen(character)) {
      result += kReplacement;
    } else if (is_control(character.front())) {
      result += picture(character.front());
    } else {
      result += character;
    }
    text.remove_prefix(std::max<std::size_t>(character.size(), 1));
  }
  return result;
}

std::string csv(std::string_view text) {
  // The # that begins a comment to many readers is quoted too.
  if (text.find_first_of(",\"\r\n#") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string shell(std::string_view text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./=,:@%";
  if (text.find('\0') != std::string_view::npos)
    throw InvalidParameterError("'" + printable(text) + "': no word of a shell can hold a NUL");
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  const bool shown_as_it_is = printable(text) == text;
  std::string word = shown_as_it_is ? "'" : "$'";
  for (const char c : text) {
    const bool unseen = !shown_as_it_is && (is_control(c) || static_cast<unsigned char>(c) >= 0x80);
    if (unseen) {
      word += by_number(c);
    } else if (c == '\'') {
      word += shown_as_it_is ? "'\\''" : "\\'";
    } else {
      word += c == '\\' && !shown_as_it_is ? std::string("\\\\") : std::string(1, c);
    }
  }
  return word + "'";
}

std::string sbatch(std::string_view text) {
  if (printable(text) != text || text.find_first_of("\"\\") != std::string_view::npos)
    throw InvalidParameterError(
        "'" + printable(text) +
        "': in a script, Slurm reads no control characters, double quotes, backslashes and "
        "bytes that are not UTF-8");
  const bool plain =
      !text.empty() && text.front() != ':' && text.find_first_of(" '#") == std::string_view::npos;
  return plain ? std::string(text) : "\"" + std::string(text) + "\"";
}

std::string gnuplot(std::string_view text) {
  // Four digits, the first a 0: gnuplot takes no more, whatever follows.
  const auto number = [](char c) { return by_number(c).insert(1, 1, '0'); };
  std::string result = "\"";
  for (const char c : printable(text)) {
    const bool plain =
        static_cast<unsigned char>(c) >= 0x80 || c == ' ' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    // A backslash for the enhanced mode is itself written by its number.
    if (std::string_view("_^{}@&~$\\").find(c) != std::string_view::npos) result += number('\\');
    if (c == '%') {
      result += number('\\') +
                "045";  // the enhanced mode's number: a tic's label is a format, where % has a meaning
    } else {
      result += plain ? std::string(1, c) : number(c);
    }
  }
  return result + "\"";
}

std::string markup(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) result += entity(c);
  return result;
}

std::string xml_attribute(std::string_view whole) {
  std::string result;
  std::string_view text = whole;
  while (!text.empty()) {
    const std::string_view character = utf8::first_character(text);
    const bool is_space = character == "\t" || character == "\n" || character == "\r";
    if (character.empty() || character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF" ||
        (static_cast<unsigned char>(character.front()) < 0x20 && !is_space)) {
      throw InvalidParameterError("'" + printable(whole) + "' cannot be written to an XML file");
    }
    // A reader takes those that are written as they are for blanks.
    if (is_space) result += "&#" + std::to_string(static_cast<int>(character.front())) + ";";
    if (!is_space) result += character.size() == 1 ? entity(character.front()) : std::string(character);
    text.remove_prefix(character.size());
  }
  return result;
}

std::string script(std::string_view json) {
  std::string result;
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";  // within strings alone does JSON have one
    } else {
      result += c;
    }
  }
  return result;
}

std::string markdown(std::string_view text) { return marked(text, "\\|*_<>[]`#~&!$", '\\'); }

}  // namespace raygauge::language
