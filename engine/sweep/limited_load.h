// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// What a SolveMethod is too whose load() takes much longer than a pass over the points.
class LimitedLoad {
 public:
  virtual ~LimitedLoad() = default;

  /// Bounds the loads that follow: one that would take longer than `seconds` ends, and so does the solve,
  /// with time_limit. The time limit of a solve is for its load too.
  virtual void limit_load(double seconds) = 0;
};

/// Bounds the loads of a method that can be bounded.
inline void limit_load(SolveMethod& method, double seconds) {
  if (auto* limited = dynamic_cast<LimitedLoad*>(&method)) limited->limit_load(seconds);
}

}  // namespace raygauge
