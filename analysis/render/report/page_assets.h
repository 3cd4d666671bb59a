// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge::report {

// The files of page/ and Chart.js, compiled in (cmake/EmbedPage.cmake): the program needs none of them to
// run.

std::string page_template();
std::string page_style();
std::string page_script();
/// Chart.js with its copyright notice.
std::string chart_library();

}  // namespace raygauge::report
