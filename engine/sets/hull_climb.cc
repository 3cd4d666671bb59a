// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/hull_climb.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

double height(const HullGraph& graph, std::int32_t i, const Vector3& v) noexcept {
  const double* p = graph.vertices + 4 * std::ptrdiff_t{i};
  return v.x * p[0] + v.y * p[1] + v.z * p[2];
}

int cell_along(double coordinate, double largest, int cells) noexcept {
  const double share = (coordinate / largest + 1) * 0.5 * cells;
  return std::clamp(static_cast<int>(share), 0, cells - 1);
}

}  // namespace

int direction_cell(const Vector3& v, int cells) noexcept {
  const double ax = std::fabs(v.x), ay = std::fabs(v.y), az = std::fabs(v.z);
  const double largest = std::max({ax, ay, az});
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  int face = 0;
  double first = v.y, second = v.z;
  if (ax >= ay && ax >= az) {
    face = v.x < 0 ? 1 : 0;
  } else if (ay >= az) {
    face = v.y < 0 ? 3 : 2;
    first = v.x;
  } else {
    face = v.z < 0 ? 5 : 4;
    first = v.x;
    second = v.y;
  }
  return (face * cells + cell_along(first, largest, cells)) * cells + cell_along(second, largest, cells);
}

std::int32_t climb(const HullGraph& graph, const Vector3& v, std::int32_t from) noexcept {
  std::int32_t best = from >= 0 ? from : graph.start[direction_cell(v, graph.cells)];
  double top = height(graph, best, v);
  for (;;) {
    std::int32_t higher = best;
    for (std::int32_t e = graph.first[best]; e < graph.first[best + 1]; ++e) {
      const std::int32_t next = graph.neighbours[e];
      const double value = height(graph, next, v);
      if (value > top) {
        top = value;
        higher = next;
      }
    }
    if (higher == best) return best;
    best = higher;
  }
}

}  // namespace raygauge
