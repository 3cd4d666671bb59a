// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/cores/core_parts.h"

namespace raygauge {

/// {c}, the core of a ball.
struct PointCore {
  static constexpr bool kIsSmooth = true;
  static constexpr int kPieces = 1, kFirstPiece = 0;

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return 1; }
  Vector3 vertex(std::int32_t /*i*/) const { return shape.center; }

  template <class Real>
  VertexView<PointCore, Real> look(const BasicVector3<Real>& v, InstructionSet /*isa*/) const {
    return {*this, v, 0};
  }

  template <class Real>
  BasicVector3<Real> nearest(const BasicVector3<Real>& /*y*/) const {
    return vector_of<Real>(shape.center);
  }

  CoreEnds ends_around(const Vector3& /*x*/) const { return {.count = 1}; }
  Matrix3 half_axes() const { return {}; }
};

}  // namespace raygauge
