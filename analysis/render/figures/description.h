// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/render/gnuplot.h"

namespace raygauge {

/// gnuplot's picture with what it leaves out: an SVG gets its title and description, which a screen reader
/// reads, a PNG its pixels an inch, which print programs go by. A PDF stays as it is.
std::string described(std::string picture, ImageFormat format, const std::string& title,
                      const std::string& description);

}  // namespace raygauge
