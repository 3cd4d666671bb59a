// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace raygauge {

/// A point of a PointSet, by its index, and its weight in a convex combination.
struct PointWeight {
  std::ptrdiff_t index = 0;
  double weight = 0;
};

}  // namespace raygauge
