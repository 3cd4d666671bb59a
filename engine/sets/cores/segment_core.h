// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/sets/cores/core_parts.h"

namespace raygauge {

/// conv{top, base}, the core of a capsule.
struct SegmentCore {
  static constexpr int kPieces = 2, kFirstPiece = 1;

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return 2; }
  Vector3 vertex(std::int32_t i) const { return i == 0 ? shape.top : shape.base; }

  template <class Real>
  VertexView<SegmentCore, Real> look(const BasicVector3<Real>& v, InstructionSet /*isa*/) const {
    const BasicVector3<Real> way = vector_of<Real>(shape.top) - vector_of<Real>(shape.base);
    return {*this, v, high(dot(v, way)) >= 0 ? 0 : 1};
  }

  int top(const Vector3& v, double tilt, Vector3 (&end)[2]) const {
    const Vector3 way = shape.top - shape.base;
    const double along = dot(v, way);
    if (along * along > tilt * tilt * dot(way, way)) return 1;
    end[0] = shape.top;
    end[1] = shape.base;
    return 2;
  }

  template <class Real>
  BasicVector3<Real> nearest(const BasicVector3<Real>& y) const {
    const BasicVector3<Real> base = vector_of<Real>(shape.base), way = vector_of<Real>(shape.top) - base;
    const Real square = dot(way, way), along = dot(y - base, way);
    if (!(along > Real{0})) return base;
    return along < square ? base + way * (along / square) : vector_of<Real>(shape.top);
  }

  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const {
    for_vertices_near_top(*this, v, margin, isa, use);
  }

  CoreEnds ends_around(const Vector3& x) const {
    constexpr double kAtEnd = 1 - 1e-6;
    const Vector3& half = shape.axis.column[0];
    const double along = dot(x - shape.center, half), square = dot(half, half);
    const std::int32_t nearer = along < 0 ? 1 : 0;
    if (std::fabs(along) > kAtEnd * square) return {1, {nearer, nearer}};
    return {2, {nearer, 1 - nearer}, square > 0 ? 0.5 + 0.5 * std::fabs(along) / square : 1.0};
  }

  template <class Use>
  void generators(const Use& use) const {
    use(shape.axis.column[0]);
  }

  Matrix3 half_axes() const { return {{shape.axis.column[0], {}, {}}}; }
};

}  // namespace raygauge
