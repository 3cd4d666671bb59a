// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

/// A unit in which times of one size read well.
struct TimeUnit {
  const char* name;   ///< "µs"
  double per_second;  ///< 1e6
};

/// µs, ms or s for an axis from `low` to `high` seconds: the one in which their geometric mean lies between
/// 0.3 and 300.
TimeUnit time_unit_for(double low, double high);

}  // namespace raygauge
