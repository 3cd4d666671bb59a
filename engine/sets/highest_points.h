// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/kernels/kernel.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// A point of a set that is highest along some u, and how many were compared to find it.
struct Highest {
  double value = 0;          ///< max_i u·p_i
  std::ptrdiff_t index = 0;  ///< the smallest index that attains it
  std::ptrdiff_t compared = 0;
};

/// By a pass over the points of S, or through their tree of clusters where S has one.
Highest highest_point(const Kernels& kernels, const PointSet& S, const double* u);

/// max_i u·p_i; the points above its threshold join `found` (Kernels::collect).
double collect_points(const Kernels& kernels, const PointSet& S, const double* u, Collection& found);

}  // namespace raygauge
