// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/sets/cores/core_parts.h"

namespace raygauge {

/// {x | base <= x <= top}. Bit k of a vertex's index: whether coordinate k is that of the base.
struct BoxCore {
  static constexpr int kPieces = 0, kFirstPiece = 0;

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return 8; }
  Vector3 vertex(std::int32_t i) const {
    const Vector3 *of_x = (i & 1) != 0 ? &shape.base : &shape.top,
                  *of_y = (i & 2) != 0 ? &shape.base : &shape.top,
                  *of_z = (i & 4) != 0 ? &shape.base : &shape.top;
    return {of_x->x, of_y->y, of_z->z};
  }

  template <class Real>
  VertexView<BoxCore, Real> look(const BasicVector3<Real>& v, InstructionSet /*isa*/) const {
    return {*this, v, (high(v.x) < 0 ? 1 : 0) | (high(v.y) < 0 ? 2 : 0) | (high(v.z) < 0 ? 4 : 0)};
  }

  int top(const Vector3& v, double tilt, Vector3 (&end)[2]) const {
    const int x = std::fabs(v.x) > tilt ? 0 : 1, y = std::fabs(v.y) > tilt ? 0 : 1,
              z = std::fabs(v.z) > tilt ? 0 : 1, flat = x + y + z;
    if (flat == 1) {
      const std::int32_t index = (v.x < 0 ? 1 : 0) | (v.y < 0 ? 2 : 0) | (v.z < 0 ? 4 : 0);
      end[0] = vertex(index);
      end[1] = vertex(index ^ (x + 2 * y + 4 * z));
    }
    return flat < 2 ? 1 + flat : 0;
  }

  template <class Real>
  BasicVector3<Real> nearest(const BasicVector3<Real>& y) const {
    const auto clamped = [](const Real& at, double low, double top) {
      if (at < Real{low}) return Real{low};
      return at > Real{top} ? Real{top} : at;
    };
    return {clamped(y.x, shape.base.x, shape.top.x), clamped(y.y, shape.base.y, shape.top.y),
            clamped(y.z, shape.base.z, shape.top.z)};
  }

  double way_out(const Vector3& y, Vector3& outward) const {
    const double room[6] = {y.x - shape.base.x, shape.top.x - y.x,  y.y - shape.base.y,
                            shape.top.y - y.y,  y.z - shape.base.z, shape.top.z - y.z};
    int least = 0;
    for (int i = 1; i < 6; ++i) least = room[i] < room[least] ? i : least;
    const double side = least % 2 == 0 ? -1.0 : 1.0;
    outward = {least / 2 == 0 ? side : 0.0, least / 2 == 1 ? side : 0.0, least / 2 == 2 ? side : 0.0};
    return room[least];
  }

  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const {
    for_vertices_near_top(*this, v, margin, isa, use);
  }

  template <class Use>
  void generators(const Use& use) const {
    const Matrix3 axes = half_axes();
    for (const Vector3& each : axes.column) use(each);
  }

  Matrix3 half_axes() const {
    const Vector3& half = shape.axis.column[0];
    return {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}};
  }
};

}  // namespace raygauge
