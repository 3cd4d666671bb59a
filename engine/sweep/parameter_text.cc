// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/parameter_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <variant>

namespace raygauge {
namespace {

struct Escape {
  char character;
  char letter;
};
constexpr std::array<Escape, 5> kEscapes = {
    {{'"', '"'}, {'\\', '\\'}, {'\n', 'n'}, {'\r', 'r'}, {'\t', 't'}}};

/// The quoted value that begins at `position`, which is then behind it.
std::string take_quoted(const std::string& text, std::size_t& position) {
  std::string value;
  for (++position; position < text.size() && text[position] != '"'; ++position) {
    if (text[position] != '\\' || position + 1 == text.size()) {
      value += text[position];
      continue;
    }
    const char letter = text[++position];
    char character = letter;
    for (const Escape& escape : kEscapes) {
      if (escape.letter == letter) character = escape.character;
    }
    value += character;
  }
  if (position < text.size()) ++position;
  return value;
}

/// The whole text as a number.
template <class Number>
Number number_of(const std::string& name, const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end)
    throw InvalidParameterError("parameter '" + name + "': '" + text + "' is no such number");
  return value;
}

/// The text as a value of the same type as `model`.
ParameterValue value_like(const ParameterValue& model, const std::string& name, const std::string& text) {
  if (std::holds_alternative<bool>(model)) return text == "true";
  if (std::holds_alternative<std::int64_t>(model)) return number_of<std::int64_t>(name, text);
  if (std::holds_alternative<double>(model)) return number_of<double>(name, text);
  return text;
}

}  // namespace

std::string quoted_where_needed(const std::string& text) {
  if (text.find_first_of(" \"\\\n\r\t") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    char letter = 0;
    for (const Escape& escape : kEscapes) {
      if (escape.character == c) letter = escape.letter;
    }
    if (letter != 0) result += '\\';
    result += letter != 0 ? letter : c;
  }
  return result + '"';
}

std::vector<std::pair<std::string, std::string>> split_parameters(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> parameters;
  std::size_t position = 0;
  while (position < text.size()) {
    const std::size_t end = std::min(text.find(' ', position), text.size());
    const std::size_t equals = text.find('=', position);
    if (equals >= end) {  // no name: more of the value before
      const std::string word = text.substr(position, end - position);
      if (!parameters.empty()) parameters.back().second += " " + word;
      position = end + 1;
      continue;
    }
    const std::string name = text.substr(position, equals - position);
    position = equals + 1;
    std::string value;
    if (position < text.size() && text[position] == '"') {
      value = take_quoted(text, position);
    } else {
      value = text.substr(position, end - position);
      position = end;
    }
    parameters.emplace_back(name, value);
    ++position;
  }
  return parameters;
}

Parameters parameters_from(const std::string& text, const std::vector<ParameterInfo>& declared) {
  Parameters parameters;
  for (const auto& [name, value] : split_parameters(text)) {
    const auto info = std::find_if(declared.begin(), declared.end(),
                                   [&, &key = name](const ParameterInfo& each) { return each.name == key; });
    if (info == declared.end()) {
      std::vector<std::string> names;
      for (const ParameterInfo& each : declared) names.push_back(each.name);
      throw UnknownNameError("parameter", name, names);
    }
    parameters[name] = value_like(info->default_value, name, value);
  }
  return parameters;
}

}  // namespace raygauge
