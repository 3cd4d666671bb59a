// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/page_template.h"

#include <algorithm>

namespace raygauge {

std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& texts) {
  std::string result;
  for (const auto& [mark, text] : texts) {
    const std::size_t place = std::min(page.find(mark), page.size());
    result.append(page.substr(0, place)).append(text);
    page.remove_prefix(std::min(place + mark.size(), page.size()));
  }
  return result.append(page);
}

}  // namespace raygauge
