// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "results/text/language.h"

namespace raygauge {

/// A page with a text in the place of each mark of its template, where the marks stand in the order of the
/// list. What a text contains is not looked at: a name may be spelled as a mark.
std::string filled(std::string_view page, const std::vector<std::pair<std::string_view, std::string>>& texts);

/// A value of nlohmann's as a page's script reads it.
template <class Json>
std::string script_json(const Json& value) {
  return language::script(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace raygauge
