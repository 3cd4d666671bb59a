// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

/// ln x for a finite x > 0, within 4 units in the last place, from + - * / and exact operations alone: the
/// same bits on every IEEE 754 machine, which std::log does not promise.
double portable_log(double x);

}  // namespace raygauge
