// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/tikz.h"

#include <algorithm>
#include <cstddef>

#include "results/text/language.h"

namespace raygauge {
namespace {

/// The end of a group in braces that begins at `open`, behind its closing brace.
std::size_t end_of_group(const std::string& text, std::size_t open) {
  std::size_t depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == '{') {
      ++depth;
    } else if (text[i] == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return text.size();
}

}  // namespace

std::string tex_of_enhanced(const std::string& text) {
  std::string tex;
  std::string plain;
  const auto flush = [&] {
    tex += language::latex(plain);
    plain.clear();
  };
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\\' && i + 1 < text.size()) {
      plain += text[i + 1];
      i += 2;
    } else if (text[i] == '$') {
      const std::size_t end = std::min(text.find('$', i + 1), text.size() - 1);
      flush();
      tex += text.substr(i, end + 1 - i);
      i = end + 1;
    } else if ((text[i] == '^' || text[i] == '_') && i + 1 < text.size()) {
      const std::size_t end = text[i + 1] == '{' ? end_of_group(text, i + 1) : i + 2;
      flush();
      tex += "$" + text.substr(i, end - i) + "$";
      i = end;
    } else {
      plain += text[i++];
    }
  }
  flush();
  return tex;
}

std::string with_tex_texts(const std::string& picture) {
  std::string result;
  for (std::size_t begin = 0; begin < picture.size();) {
    const std::size_t end = std::min(picture.find('\n', begin), picture.size() - 1) + 1;
    const std::string line = picture.substr(begin, end - begin);
    const std::size_t open = line.starts_with("\\node") ? line.find(") {") : std::string::npos;
    const std::size_t close = line.rfind("};");
    if (open == std::string::npos || close == std::string::npos || close < open + 3) {
      result += line;
    } else {
      result += line.substr(0, open + 3) + tex_of_enhanced(line.substr(open + 3, close - open - 3)) +
                line.substr(close);
    }
    begin = end;
  }
  return result;
}

}  // namespace raygauge
