// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/methods/options.h"

namespace raygauge {

/// What is wrong with `options`, the first thing in one line that begins with the name of the option:
/// "tolerance must lie in (0, 1), got 2"; empty if nothing is. A solver throws InvalidParameterError with
/// this line.
std::string validate(const DistanceOptions& options);

}  // namespace raygauge
