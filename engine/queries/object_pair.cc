// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/object_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sets/parameters.h"

namespace raygauge {

void SupportPairs::add(const double* difference, const double* a1) {
  const auto size = static_cast<std::size_t>(n_);
  const auto needed = static_cast<std::size_t>(count_ + 1) * 2 * size;
  if (needed > pairs_.capacity()) pairs_.reserve(2 * needed);
  double* pair = pairs_.data() + static_cast<std::size_t>(count_++) * 2 * size;
  std::copy_n(difference, n_, pair);
  std::copy_n(a1, n_, pair + n_);
}

const double* SupportPairs::partner(const double* difference) const {
  const double* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::ptrdiff_t i = count_ - 1; i >= 0 && least > 0; --i) {
    const double* pair = pairs_.data() + 2 * i * n_;
    double away = 0;
    for (int k = 0; k < n_; ++k) away = std::max(away, std::fabs(pair[k] - difference[k]));
    if (away < least) {
      least = away;
      nearest = pair + n_;
    }
  }
  return nearest;
}

ObjectPair::ObjectPair(const ConvexSet& A2, const ConvexSet& A1, SupportPairs* pairs)
    : MinkowskiView(A2.dimension()), pairs_(pairs) {
  check_dimension("object distance", "A1", A1.dimension(), dimension());
  look_at(A2, A1, -1.0);
}

}  // namespace raygauge
