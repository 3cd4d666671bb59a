// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/axis_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raygauge/sets/point_set.h"

namespace raygauge {

void AxisPoints::find(const PricedPoints& points, int n) {
  constexpr int kLanes = PointSet::kLanes;
  const std::size_t size = 2 * static_cast<std::size_t>(n);
  n_ = n;
  found_ = 0;
  index_.reserve(size);
  length_.reserve(size);
  std::fill_n(index_.data(), size, std::ptrdiff_t{-1});
  std::fill_n(length_.data(), size, 0.0);
  for (std::ptrdiff_t block = 0; block < points.block_count; ++block) {
    const double* data = points.blocks + block * n * kLanes;
    std::array<int, kLanes> nonzeros{};
    std::array<int, kLanes> last{};
    int open = kLanes;  // lanes that may still lie on an axis
    for (int k = 0; k < n && open > 0; ++k) {
      for (int lane = 0; lane < kLanes; ++lane) {
        if (data[static_cast<std::ptrdiff_t>(k) * kLanes + lane] == 0) continue;
        const auto at = static_cast<std::size_t>(lane);
        last[at] = k;
        if (++nonzeros[at] == 2) --open;
      }
    }
    for (std::size_t lane = 0; lane < kLanes && open > 0; ++lane) {
      if (nonzeros[lane] != 1) continue;
      const auto k = static_cast<std::ptrdiff_t>(last[lane]);
      note(block * kLanes + static_cast<std::ptrdiff_t>(lane), last[lane],
           data[k * kLanes + static_cast<std::ptrdiff_t>(lane)]);
    }
  }
  // Lanes beyond the last point repeat it.
  for (std::size_t i = 0; i < size; ++i) index_[i] = std::min(index_[i], points.size - 1);
}

void AxisPoints::note(std::ptrdiff_t point, int k, double coordinate) {
  const std::size_t half_axis = at(k, coordinate > 0);
  if (!(std::fabs(coordinate) > length_[half_axis])) return;
  if (index_[half_axis] < 0) ++found_;
  index_[half_axis] = point;
  length_[half_axis] = std::fabs(coordinate);
}

}  // namespace raygauge
