// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/time_unit.h"

#include <cmath>

namespace raygauge {

TimeUnit time_unit_for(double low, double high) {
  constexpr double kMicro = 3e-4;
  constexpr double kMilli = 0.3;
  const double middle = std::sqrt(low * high);
  if (middle < kMicro) return {"µs", 1e6};
  if (middle < kMilli) return {"ms", 1e3};
  return {"s", 1};
}

}  // namespace raygauge
