// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/torus.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace raygauge::bench {

TriangleSource torus(std::int64_t triangles) {
  const auto k = static_cast<int>(std::sqrt(static_cast<double>(triangles))),
             l = static_cast<int>(triangles / 2 / k);
  TriangleSource mesh;
  mesh.vertices.resize(3, std::ptrdiff_t{k} * l);
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < l; ++j) {
      const double s = 2 * std::numbers::pi * i / k, t = 2 * std::numbers::pi * j / l,
                   far = 2 + 0.5 * std::cos(t);
      mesh.vertices.col(std::ptrdiff_t{i} * l + j) << far * std::cos(s), far * std::sin(s), 0.5 * std::sin(t);
      const auto at = [&](int a, int b) { return static_cast<std::int32_t>((a % k) * l + b % l); };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace raygauge::bench
