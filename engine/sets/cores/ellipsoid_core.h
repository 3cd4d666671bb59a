// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/cores/core_parts.h"

namespace raygauge {

/// {c + L z | |z| <= 1}, L the shape's `axis`.
struct EllipsoidCore {
  static constexpr bool kIsCurved = true, kIsSmooth = true;
  static constexpr int kAxes = 3;
  static constexpr int kPieces = 1, kFirstPiece = kSmoothPiece;

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return 0; }
  Vector3 vertex(std::int32_t /*i*/) const { return shape.center; }

  /// h(v) = v·c + |Lᵀv|, at c + L Lᵀv/|Lᵀv|.
  template <class Real>
  struct View {
    View(const SpatialShape& of, const BasicVector3<Real>& direction)
        : shape(of), v(direction), z(transposed_times(of.axis, v)), size(square_root(dot(z, z))) {}

    BasicVector3<Real> point(std::int32_t /*piece*/) const {
      const BasicVector3<Real> center = vector_of<Real>(shape.center);
      return high(size) > 0 ? center + times(shape.axis, z * (Real{1} / size)) : center;
    }
    Real height(std::int32_t /*piece*/) const { return dot(v, shape.center) + size; }
    bool is_flat() const { return false; }

    const SpatialShape& shape;
    BasicVector3<Real> v, z;
    Real size;
    std::int32_t index = kSmoothPiece;
  };

  template <class Real>
  View<Real> look(const BasicVector3<Real>& v, InstructionSet /*isa*/) const {
    return {shape, v};
  }

  /// The Hessian at u of the core with these axes, (L Lᵀ - y yᵀ)/|Lᵀu| with y = L Lᵀu/|Lᵀu|.
  static Matrix3 form(const Matrix3& L) {
    const Vector3* c = L.column;
    return {{L * Vector3{c[0].x, c[1].x, c[2].x}, L * Vector3{c[0].y, c[1].y, c[2].y},
             L * Vector3{c[0].z, c[1].z, c[2].z}}};
  }
  CoreCurvature curvature(const Matrix3& L, const Vector3& u, std::int32_t /*piece*/) const {
    const Vector3 image = L.transposed_times(u);
    const double size = length(image);
    if (!(size > 0)) return {};
    return {L * (image * (1 / size)), 1 / size};
  }

  /// The support point for v is c + Lz, z = Lᵀv/|Lᵀv|, and c + Lz - r is inside if |z - L⁻¹r|² < 1. There
  /// z·L⁻¹r = v·r/|Lᵀv|, and |L⁻¹r| <= |r|/ρ, ρ the radius of a ball inside: it is if 2 v·r > |Lᵀv| (|r|/ρ)².
  /// v·r >= height - margin and |r| <= |back| + margin are known, and |Lᵀv| is at most twice the extent.
  template <class Real>
  bool holds(const BasicVector3<Real>& /*x*/, const BasicVector3<Real>& back, double height,
             double margin) const {
    const double r = length_of(back) + margin, radius = shape.inner_radius;
    return radius > 0 && height - margin > shape.extent * (r / radius) * (r / radius) * (1 + 0x1p-30);
  }

  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double /*margin*/, InstructionSet isa, const Use& use) const {
    const View<Real> view = look(v, isa);
    use(view.point(view.index));
  }

  Matrix3 half_axes() const { return shape.axis; }
};

}  // namespace raygauge
