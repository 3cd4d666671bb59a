// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Every figure: a new one is one file and one line in figures.cc.
const std::vector<Figure>& figures();

/// Throws UnknownNameError, which lists the known ones.
const Figure& figure_named(const std::string& name);

}  // namespace raygauge
