// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/kernels/kernel.h"
#include "engine/sets/cores/core_parts.h"
#include "raygauge/sets/direction_table.h"

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

  /// The half axes of an ellipsoid with the same second moments as the points about their centre, times 3.
  Matrix3 half_axes() const;

 private:
  std::int32_t highest(const Vector3& v, InstructionSet isa) const {
    const std::int32_t listed = shape.table != nullptr ? shape.table->highest(v) : -1;
    if (listed >= 0) return listed;
    double height = 0;
    return highest_in_pass(v, isa, height);
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

}  // namespace raygauge
