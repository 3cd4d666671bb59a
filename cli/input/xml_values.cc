// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/xml_values.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "cli/input/byte_reader.h"
#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

std::string line_text(const std::string& path, int line) {
  return path + (line > 0 ? ":" + std::to_string(line) : "");
}

bool is_blank(const char* text) { return words_of(text).empty(); }

bool only_comments(std::string_view text) {
  while (true) {
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
    if (!text.starts_with("<!--")) return text.empty();
    text.remove_prefix(std::min(text.size(), text.find("-->")));
    text.remove_prefix(std::min<std::size_t>(text.size(), 3));
  }
}

/// Programs write comments in front of <?xml … ?>, which is against the rules and changes nothing.
void blank_declaration(std::string& text) {
  const std::size_t begin = text.find("<?xml ");
  const std::size_t end = begin == std::string::npos ? begin : text.find("?>", begin);
  if (end == std::string::npos || !only_comments({text.data(), begin})) return;
  std::replace_if(
      text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end + 2),
      [](char c) { return c != '\n'; }, ' ');
}

/// "XML_ERROR_MISMATCHED_ELEMENT" as words.
std::string reason_of(const tinyxml2::XMLDocument& document) {
  std::string reason = document.ErrorName();
  constexpr std::string_view kPrefix = "XML_";
  if (reason.starts_with(kPrefix)) reason.erase(0, kPrefix.size());
  for (char& c : reason) c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return reason;
}

}  // namespace

XmlFile::XmlFile(std::string text, std::string path) : path_(std::move(path)) {
  blank_declaration(text);
  const auto fail = [&](int line, const std::string& reason) {
    throw InvalidParameterError(line_text(path_, line) + ": not XML that can be read: " + reason);
  };
  if (text.find('\0') != std::string::npos) fail(0, "it holds zero bytes");
  if (document_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    fail(document_.ErrorLineNum(), reason_of(document_));
  int roots = 0;
  for (const tinyxml2::XMLNode* node = document_.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToElement() != nullptr && ++roots > 1) fail(node->GetLineNum(), "a second root element");
    if (node->ToText() != nullptr && !is_blank(node->Value()))
      fail(node->GetLineNum(), "text outside of elements");
  }
  if (roots == 0) fail(0, "it has no element");
}

void XmlFile::refuse(const XmlElement& element, const std::string& what) const {
  throw InvalidParameterError(line_text(path_, element.GetLineNum()) + ": " + what);
}

std::string XmlFile::text(const XmlElement& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (value == nullptr) refuse(element, std::string("<") + element.Name() + "> needs the attribute " + name);
  return value;
}

double XmlFile::limit(const XmlElement& element, const char* name) const {
  if (element.Attribute(name) == nullptr) return 0;
  const std::string value = text(element, name);
  const auto words = words_of(value);
  const std::optional<double> number = words.size() == 1 ? number_of(words[0]) : std::nullopt;
  if (!number || std::isnan(*number))
    refuse(element, std::string(name) + " must be a number, got " + quoted(value));
  return *number;
}

double XmlFile::number(const XmlElement& element, const char* name) const {
  const std::string value = text(element, name);
  const auto words = words_of(value);
  const std::optional<double> number = words.size() == 1 ? number_of(words[0]) : std::nullopt;
  if (!number || !std::isfinite(*number))
    refuse(element, std::string(name) + " must be a finite number, got " + quoted(value));
  return *number;
}

double XmlFile::number(const XmlElement& element, const char* name, double otherwise) const {
  return element.Attribute(name) == nullptr ? otherwise : number(element, name);
}

std::vector<double> XmlFile::numbers(const XmlElement& element, const char* name) const {
  const std::string value = text(element, name);
  std::vector<double> numbers;
  for (const std::string_view word : words_of(value)) {
    const std::optional<double> number = number_of(word);
    if (!number || !std::isfinite(*number))
      refuse(element, std::string(name) + " must be finite numbers, got " + quoted(word));
    numbers.push_back(*number);
  }
  return numbers;
}

Eigen::Vector3d XmlFile::vector(const XmlElement& element, const char* name,
                                const Eigen::Vector3d& otherwise) const {
  const char* value = element.Attribute(name);
  if (value == nullptr) return otherwise;
  const auto words = words_of(value);
  Eigen::Vector3d vector;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> number = words.size() == 3 ? number_of(words[i]) : std::nullopt;
    if (!number || !std::isfinite(*number))
      refuse(element, std::string(name) + " must be three finite numbers, got " + quoted(value));
    vector[static_cast<Eigen::Index>(i)] = *number;
  }
  return vector;
}

}  // namespace raygauge::cli
