// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/kernels/kernel.h"
#include "engine/sets/cores/core_parts.h"
#include "engine/sets/direction_table.h"

namespace raygauge {

/// The hull of points in PointSet's layout.
struct PointsCore {
  static constexpr int kPieces = 0, kFirstPiece = 0;  // too many
  static constexpr int kLanes = 8;                    // of PointSet's blocks

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return shape.size; }
  Vector3 vertex(std::int32_t i) const {
    if (shape.table != nullptr) return shape.table->point(i);
    const int n = shape.coordinates;
    const double* p = shape.blocks + std::ptrdiff_t{i / kLanes} * n * kLanes + i % kLanes;
    return {p[0], p[kLanes], n == 3 ? p[std::ptrdiff_t{2} * kLanes] : 0.0};
  }

  template <class Real>
  VertexView<PointsCore, Real> look(const BasicVector3<Real>& v, InstructionSet isa) const {
    return {*this, v, highest(v, isa)};
  }

  /// The third highest point is far below the highest, or the second. Points of other lists than that of v
  /// only come near them at the edge of v's cell.
  int top(const Vector3& v, double tilt, Vector3 (&end)[2]) const {
    constexpr double kWidest = 4;  // of the extent: more than any two points are apart
    const double most = kWidest * tilt * shape.extent;
    double height[3] = {-__builtin_inf(), -__builtin_inf(), -__builtin_inf()};
    std::int32_t index[2] = {0, 0};
    const auto take = [&](std::int32_t i, double other) {
      const bool first = other > height[0], second = other > height[1];
      height[2] = second ? height[1] : std::max(height[2], other);
      height[1] = first ? height[0] : second ? other : height[1];
      index[1] = first ? index[0] : second ? i : index[1];
      height[0] = first ? other : height[0];
      index[0] = first ? i : index[0];
    };
    if (shape.table != nullptr) {
      for (const std::int32_t i : shape.table->listed(v)) take(i, dot(v, shape.table->point(i)));
    } else if (shape.block_count == 1 && shape.coordinates == 3) {
      const double *x = shape.blocks, *y = x + kLanes, *z = y + kLanes;
      for (std::int32_t i = 0; i < shape.size; ++i) take(i, v.x * x[i] + v.y * y[i] + v.z * z[i]);
    }
    if (height[0] - height[1] > most) return 1;
    if (!(height[0] - height[2] > most)) return 0;
    end[0] = vertex(index[0]);
    end[1] = vertex(index[1]);
    return 2;
  }

  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const;

  /// The half axes of an ellipsoid with the same second moments as the points about their centre, times 3.
  Matrix3 half_axes() const;

 private:
  /// Points of a block, by bits from the lowest on.
  struct HighBlock {
    std::ptrdiff_t block = 0;
    unsigned lanes = 0;
  };
  /// The first block from `block` on with points that are, in doubles, `floor` high or higher, and which they
  /// are; none.
  HighBlock next_high_block(const Vector3& w, double floor, std::ptrdiff_t block) const;

  std::int32_t highest(const Vector3& v, InstructionSet isa) const {
    if (shape.block_count == 1 && shape.coordinates == 3) return highest_of_block(v);
    const std::int32_t listed = shape.table != nullptr ? shape.table->highest(v) : -1;
    if (listed >= 0) return listed;
    double height = 0;
    return highest_in_pass(v, isa, height);
  }

  /// Without a branch, as which one it is cannot be guessed: the last three bits of a height give way to the
  /// index. Places behind the last point repeat it.
  std::int32_t highest_of_block(const Vector3& v) const {
    constexpr std::uint64_t kIndex = kLanes - 1;
    const double *x = shape.blocks, *y = x + kLanes, *z = y + kLanes;
    double height[kLanes];
    for (int i = 0; i < kLanes; ++i) height[i] = v.x * x[i] + v.y * y[i] + v.z * z[i];
    for (std::uint64_t i = 0; i < kLanes; ++i)
      height[i] = std::bit_cast<double>((std::bit_cast<std::uint64_t>(height[i]) & ~kIndex) | i);
    for (int half = kLanes / 2; half > 0; half /= 2)
      for (int i = 0; i < half; ++i) height[i] = height[i + half] > height[i] ? height[i + half] : height[i];
    const auto index = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(height[0]) & kIndex);
    return std::min(index, static_cast<std::int32_t>(shape.size) - 1);
  }

  /// Every point that may be the highest, but for rounding in doubles, is compared precisely.
  std::int32_t highest(const PreciseVector3& v, InstructionSet isa) const;
  std::int32_t highest_listed(const PreciseVector3& v, double noise) const;

  std::int32_t highest_in_pass(const Vector3& v, InstructionSet isa, double& height) const {
    const double u[3] = {v.x, v.y, v.z};
    std::ptrdiff_t index = 0;
    height = kernels_for(isa).price(shape.blocks, shape.block_count, shape.coordinates, u, &index);
    return static_cast<std::int32_t>(std::min(index, shape.size - 1));
  }
};

// A pass over all points in doubles; those that may be high enough are asked one by one.
template <class Real, class Use>
void PointsCore::face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const {
  constexpr double kHeightError = 0x1p-49;  // of three products in doubles, relative to |v|₁ max|x|
  const auto view = look(v, isa);
  const Vector3 w = rounded(v);
  const Real least = view.height(view.index) - Real{margin};
  // A point that no list has is lower than another one by more than that, or next to it.
  constexpr double kShareOfList = 1e-6;
  if (shape.table != nullptr && margin <= kShareOfList * shape.extent &&
      !shape.table->listed(rounded(v)).empty()) {
    for (const std::int32_t i : shape.table->listed(rounded(v))) {
      if (!(view.height(i) < least)) use(view.point(i));
    }
    return;
  }
  const double noise = kHeightError * (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z)) * shape.extent;
  const double floor = high(least) - noise;
  for (HighBlock high = next_high_block(w, floor, 0); high.lanes != 0;
       high = next_high_block(w, floor, high.block + 1)) {
    for (; high.lanes != 0; high.lanes &= high.lanes - 1) {
      const std::ptrdiff_t i = high.block * kLanes + std::countr_zero(high.lanes);
      if (i >= shape.size) continue;
      const auto index = static_cast<std::int32_t>(i);
      if (!(view.height(index) < least)) use(view.point(index));
    }
  }
}

}  // namespace raygauge
