// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/cores/points_core.h"

#include <cmath>

#include "engine/numerics/fused.h"

namespace raygauge {

// Of the points that the table lists for v; -1 where it lists none.
std::int32_t PointsCore::highest_listed(const PreciseVector3& v, double noise) const {
  const Vector3 w = rounded(v);
  const auto listed = shape.table->listed(w);
  double top = -__builtin_inf();
  for (const std::int32_t i : listed) top = std::max(top, dot(w, shape.table->point(i)));
  std::int32_t best = -1;
  DoubleDouble height;
  for (const std::int32_t i : listed) {
    const Vector3 point = shape.table->point(i);
    if (!(dot(w, point) >= top - noise)) continue;
    const DoubleDouble other = dot(v, point);
    if (best >= 0 && !(other > height)) continue;
    height = other;
    best = i;
  }
  return best;
}

// Four blocks at a time, whose highest points are compared first.
RAYGAUGE_VECTORS PointsCore::HighBlock PointsCore::next_high_block(const Vector3& w, double floor,
                                                                   std::ptrdiff_t block) const {
  using Pack [[gnu::vector_size(kLanes * sizeof(double)), gnu::aligned(8), gnu::may_alias]] = double;
  constexpr std::ptrdiff_t kTogether = 4;
  const int n = shape.coordinates;
  const double third = n == 3 ? w.z : 0.0;
  const auto heights = [&](std::ptrdiff_t i) __attribute__((always_inline)) {
    const auto* p = reinterpret_cast<const Pack*>(shape.blocks + i * n * kLanes);
    return w.x * p[0] + w.y * p[1] + third * p[n == 3 ? 2 : 0];
  };
  for (; block < shape.block_count; block += kTogether) {
    const std::ptrdiff_t end = std::min(block + kTogether, shape.block_count);
    Pack top = heights(block);
    for (std::ptrdiff_t i = block + 1; i < end; ++i) {
      const Pack height = heights(i);
      top = height > top ? height : top;
    }
    Pack other = __builtin_shufflevector(top, top, 4, 5, 6, 7, 0, 1, 2, 3);
    top = other > top ? other : top;
    other = __builtin_shufflevector(top, top, 2, 3, 0, 1, 6, 7, 4, 5);
    top = other > top ? other : top;
    if (!(top[0] >= floor) && !(top[1] >= floor)) continue;
    for (std::ptrdiff_t i = block; i < end; ++i) {
      const Pack height = heights(i);
      unsigned lanes = 0;
      for (int lane = 0; lane < kLanes; ++lane) lanes |= height[lane] >= floor ? 1U << lane : 0U;
      if (lanes != 0) return {i, lanes};
    }
  }
  return {};
}

RAYGAUGE_FUSED std::int32_t PointsCore::highest(const PreciseVector3& v, InstructionSet isa) const {
  constexpr double kHeightError = 0x1p-49;  // of three products in doubles, relative to |v|₁ max|x|
  const Vector3 w = rounded(v);
  const double noise = 4 * kHeightError * (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z)) * shape.extent;
  if (shape.table != nullptr) {
    const std::int32_t listed = highest_listed(v, noise);
    if (listed >= 0) return listed;
  }
  const int n = shape.coordinates;
  double top = 0;
  std::int32_t best = highest_in_pass(w, isa, top);
  const double floor = top - noise;
  DoubleDouble height = dot(v, vertex(best));
  const double third = n == 3 ? w.z : 0.0;
  for (std::ptrdiff_t block = 0; block < shape.block_count; ++block) {
    const double* p = shape.blocks + block * n * kLanes;
    const double* z = n == 3 ? p + std::ptrdiff_t{2} * kLanes : p;
    double value[kLanes];
    int above = 0;
    for (int lane = 0; lane < kLanes; ++lane)
      value[lane] = w.x * p[lane] + w.y * p[kLanes + lane] + third * z[lane];
    for (const double each : value) above += each >= floor ? 1 : 0;
    for (int lane = 0; above > 0 && lane < kLanes; ++lane) {
      const std::ptrdiff_t candidate = block * kLanes + lane;
      if (!(value[lane] >= floor) || candidate == best || candidate >= shape.size) continue;
      const DoubleDouble other = dot(v, vertex(static_cast<std::int32_t>(candidate)));
      if (!(other > height)) continue;
      height = other;
      best = static_cast<std::int32_t>(candidate);
    }
  }
  return best;
}

// The columns of C in  C Cᵀ = 3/N Σ (x - c)(x - c)ᵀ,  which is L Lᵀ for points all over an ellipsoid.
Matrix3 PointsCore::half_axes() const {
  double M[3][3] = {};
  const double share = 3 / static_cast<double>(shape.size);
  for (std::ptrdiff_t i = 0; i < shape.size; ++i) {
    const Vector3 way = vertex(static_cast<std::int32_t>(i)) - shape.center;
    const double x[3] = {way.x, way.y, way.z};
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k <= j; ++k) M[j][k] += share * x[j] * x[k];
    }
  }
  double C[3][3] = {};
  for (int k = 0; k < 3; ++k) {
    for (int j = k; j < 3; ++j) {
      double rest = M[j][k];
      for (int i = 0; i < k; ++i) rest -= C[j][i] * C[k][i];
      C[j][k] = j == k ? std::sqrt(std::max(rest, 0.0)) : C[k][k] > 0 ? rest / C[k][k] : 0.0;
    }
  }
  return {{{C[0][0], C[1][0], C[2][0]}, {0, C[1][1], C[2][1]}, {0, 0, C[2][2]}}};
}

}  // namespace raygauge
