// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/render/table.h"
#include "analysis/studies/pivot/pivot.h"

namespace raygauge {

/// The pivot as a table: values with 3 significant digits, `intervals` beside them if wanted, footnotes for
/// what is unsolved, disagrees or has no value.
/// With `separate` the ends of intervals are columns of their own.
Table pivot_table(const Pivot& pivot, bool intervals = false, bool separate = false);

}  // namespace raygauge
