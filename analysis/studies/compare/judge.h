// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/studies/compare/compare.h"

namespace raygauge {

/// Whether a ratio is further from 1 than the threshold, up or down.
bool beyond_threshold(double ratio, double threshold);

/// Fills in what needs all findings at once: adjusted p values, the spread between runs, and the changes.
void judge(Comparison& comparison);

}  // namespace raygauge
