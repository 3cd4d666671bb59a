// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/methods/result.h"

#include <algorithm>
#include <cmath>

namespace raygauge {

const double* recorded_normal(const PairStart& warm, int n) noexcept {
  const auto size = static_cast<std::size_t>(n);
  if (warm.dimension != n || (n > 3 && warm.long_normal.size() != size)) return nullptr;
  const double* normal = n <= 3 ? warm.normal.data() : warm.long_normal.data();
  const bool finite = std::all_of(normal, normal + n, [](double u_k) { return std::isfinite(u_k); });
  const bool zero = std::all_of(normal, normal + n, [](double u_k) { return u_k == 0; });
  return finite && !zero ? normal : nullptr;
}

void record_normal(const Vector& normal, PairStart& warm) {
  const auto n = static_cast<int>(normal.size());
  warm.dimension = n;
  warm.count = 0;
  if (n > 3) warm.long_normal.resize(static_cast<std::size_t>(n));
  std::copy_n(normal.data(), n, n <= 3 ? warm.normal.data() : warm.long_normal.data());
}

}  // namespace raygauge
