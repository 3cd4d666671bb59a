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

  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const {
    for_vertices_near_top(*this, v, margin, isa, use);
  }

  CoreEnds ends_around(const Vector3& /*x*/) const { return {.count = 1}; }
  Matrix3 half_axes() const { return {}; }
};

}  // namespace raygauge
