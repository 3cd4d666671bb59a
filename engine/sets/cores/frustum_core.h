// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/sets/cores/core_parts.h"

namespace raygauge {

/// The hull of two discs across an axis: cylinders, cones, truncated cones. Its smooth pieces are the rims.
struct FrustumCore {
  static constexpr bool kIsCurved = true;
  static constexpr int kAxes = 1;
  static constexpr std::int32_t kBase = -2, kTop = -3;  ///< rims
  static constexpr int kPieces = 2, kFirstPiece = kBase;
  static constexpr std::int32_t kBaseDisc = -4, kTopDisc = -5;  ///< within them

  const SpatialShape& shape;

  std::ptrdiff_t vertex_count() const { return 0; }
  Vector3 vertex(std::int32_t /*i*/) const { return shape.center; }

  /// The axis a: in doubles of length 1, else from the base to the top without rounding; |a|², 1/|a|², and
  /// `full` a is the way from the base to the top.
  template <class Real>
  struct Axis {
    explicit Axis(const SpatialShape& of) {
      if constexpr (kIsDouble<Real>) {
        a = of.axis.column[0];
      } else {
        a = vector_of<Real>(of.top) - vector_of<Real>(of.base);
        square = dot(a, a);
        inverse = Real{1} / square;
      }
    }
    Real full(const SpatialShape& of) const {
      if constexpr (kIsDouble<Real>) return dot(of.top - of.base, a);
      return Real{1};
    }
    BasicVector3<Real> without(const BasicVector3<Real>& v) const { return v - a * (dot(v, a) * inverse); }

    BasicVector3<Real> a;
    Real square{1}, inverse{1};
  };

  /// A direction v as the rims see it: v_⊥ across the axis, of which they have w = v_⊥/|v_⊥|; zero for v
  /// along the axis.
  template <class Real>
  struct Across {
    Across(const Axis<Real>& axis, const BasicVector3<Real>& v) {
      constexpr double kCancelled =
          kIsDouble<Real> ? 0.04 : 0.01;  // |v_⊥|²/|v|² below which the projection is repeated
      constexpr double kAlongAxis = kIsDouble<Real> ? 1e-28 : 1e-56;  // ... and that is nothing but rounding
      constexpr double kNearAxis = 1e-10;  // ... and up to which rims are as good as flat
      const double all = dot(rounded(v), rounded(v));
      w = axis.without(v);
      Real square = dot(w, w);
      if (!(high(square) > kCancelled * all)) {
        w = axis.without(w);
        square = dot(w, w);
      }
      size = square_root(square);
      is_near_axis = !(high(square) > kNearAxis * all);
      if (high(square) > kAlongAxis * all) {
        w = w * (Real{1} / size);
      } else {
        w = {};
        size = Real{0};
      }
    }

    BasicVector3<Real> w;
    Real size;
    bool is_near_axis;
  };

  static constexpr std::int32_t other_piece(std::int32_t rim) { return kBase + kTop - rim; }
  double radius_of(std::int32_t rim) const { return rim == kTop ? shape.top_radius : shape.base_radius; }
  const Vector3& center_of(std::int32_t rim) const { return rim == kTop ? shape.top : shape.base; }

  template <class Real>
  struct View {
    View(const FrustumCore& of, const BasicVector3<Real>& direction)
        : core(of), v(direction), across(Axis<Real>(of.shape), direction) {}

    BasicVector3<Real> point(std::int32_t rim) const {
      return vector_of<Real>(core.center_of(rim)) + across.w * Real{core.radius_of(rim)};
    }
    Real height(std::int32_t rim) const {
      return dot(v, core.center_of(rim)) + across.size * core.radius_of(rim);
    }
    /// So near to the axis that points of rims say nothing.
    bool is_flat() const { return across.is_near_axis; }

    const FrustumCore& core;
    BasicVector3<Real> v;
    Across<Real> across;
    std::int32_t index = height(kTop) > height(kBase) ? kTop : kBase;
  };

  template <class Real>
  View<Real> look(const BasicVector3<Real>& v, InstructionSet /*isa*/) const {
    return {*this, v};
  }

  /// The point of a rim that is the highest one along v.
  static constexpr bool is_rim(std::int32_t index) { return index == kBase || index == kTop; }
  Vector3 top_of_rim(const Vector3& v, std::int32_t rim) const {
    return center_of(rim) + Across<double>(Axis<double>(shape), v).w * radius_of(rim);
  }

  /// The point of one rim, v not along the axis of its disc, or a line of the side.
  int top(const Vector3& v, double tilt, Vector3 (&end)[2]) const {
    constexpr double kBesideAxis = 1e-4;  // |v_⊥|²: no digits of it are lost that count
    const double widening = shape.top_radius - shape.base_radius, width = shape.full + std::fabs(widening);
    const double along = dot(v, shape.axis.column[0]), square = 1 - along * along;
    const double higher = along * shape.full + std::sqrt(square) * widening;
    if (square > kBesideAxis && std::fabs(higher) > tilt * width) return 1;
    const View<double> view(*this, v);
    if (square > kBesideAxis) {
      end[0] = view.point(kTop);
      end[1] = view.point(kBase);
      return 2;
    }
    const bool one_rim = std::fabs(view.height(kTop) - view.height(kBase)) > tilt * width;
    return one_rim && (view.across.size > tilt || !(radius_of(view.index) > 0)) ? 1 : 0;
  }

  /// The Hessian of a rim at u, radius/|u_⊥| (1 - a aᵀ - w wᵀ), of the core with this axis.
  static Matrix3 form(const Matrix3& axis) {
    const Vector3& a = axis.column[0];
    return {{Vector3{1, 0, 0} - a * a.x, Vector3{0, 1, 0} - a * a.y, Vector3{0, 0, 1} - a * a.z}};
  }
  CoreCurvature curvature(const Matrix3& axis, const Vector3& u, std::int32_t rim) const {
    const Vector3& a = axis.column[0];
    const Vector3 w = u - a * dot(u, a);
    const double square = dot(w, w), size = std::sqrt(square);
    if (!(square > 1e-28 * dot(u, u))) return {};
    return {w * (1 / size), radius_of(rim) / size};
  }

  /// The disc on the side of v, with its outward axis.
  CoreDisc disc(const Vector3& v) const {
    const Vector3& a = shape.axis.column[0];
    if (dot(v, a) > 0) return {kTopDisc, a, shape.top, shape.top_radius};
    return {kBaseDisc, -a, shape.base, shape.base_radius};
  }

  /// Of the disc on the side of v, the corners of a regular polygon of kFaceCorners that is fixed to the
  /// body, as far as they are within the margin. Where not all are, or v looks rather at the side: the
  /// highest points of the rims within the margin.
  template <class Real, class Use>
  void face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const;

  static constexpr int kFaceCorners = 32;  ///< the disc extends beyond the polygon by 0.0048 of its radius

  /// In the half plane through the axis that holds y: `along` a from the base and `across` it.
  template <class Real>
  BasicVector3<Real> nearest(const BasicVector3<Real>& y) const;

  double way_out(const Vector3& y, Vector3& outward) const;

  /// Whether the ball of radius `margin` about x - back is inside, for certain.
  template <class Real>
  bool holds(const BasicVector3<Real>& x, const BasicVector3<Real>& back, double height, double margin) const;

  Matrix3 half_axes() const {
    const Vector3 across = any_orthogonal(shape.axis.column[0]);
    const double radius = 0.5 * (shape.base_radius + shape.top_radius);
    return {{(shape.top - shape.base) * 0.5, across * radius, cross(shape.axis.column[0], across) * radius}};
  }
};

template <class Real>
BasicVector3<Real> FrustumCore::nearest(const BasicVector3<Real>& y) const {
  const Axis<Real> axis(shape);
  const BasicVector3<Real> base = vector_of<Real>(shape.base), x = y - base;
  const Real along = dot(x, axis.a) * axis.inverse, full = axis.full(shape);
  const BasicVector3<Real> radial = x - axis.a * along;
  const Real across = square_root(dot(radial, radial));
  const Real base_radius{shape.base_radius}, widening = difference<Real>(shape.top_radius, shape.base_radius);
  const bool below = !(along > Real{0}), above = !(along < full);
  if (below && !(across > base_radius)) return base + radial;
  if (above && !(across > Real{shape.top_radius})) return vector_of<Real>(shape.top) + radial;
  if (!below && !above && !(across * full > base_radius * full + along * widening)) return y;
  Real share = (along * full * axis.square + (across - base_radius) * widening) /
               (full * full * axis.square + widening * widening);
  if (share < Real{0}) share = Real{0};
  if (share > Real{1}) share = Real{1};
  const Real radius = base_radius + share * widening;
  return base + axis.a * (share * full) + radial * (radius / across);
}

// Through a disc, or through the side in the half plane of y, where that is a line. At the axis, where the
// way from it is lost in rounding, any half plane does.
inline double FrustumCore::way_out(const Vector3& y, Vector3& outward) const {
  constexpr double kAtAxis = 1e-10;  // of |y - base|
  const Axis<double> axis(shape);
  const Vector3 x = y - shape.base;
  const double along = dot(x, axis.a), full = axis.full(shape);
  Vector3 radial = axis.without(x);
  const double across = length(radial), widening = shape.top_radius - shape.base_radius;
  if (!(across > kAtAxis * length(x))) radial = any_orthogonal(axis.a);
  radial = axis.without(radial);
  const double slant = std::sqrt(full * full + widening * widening);
  const double side = ((shape.base_radius - across) * full + along * widening) / slant;
  if (side < along && side < full - along) {
    outward = radial * (full / length(radial)) - axis.a * widening;
    outward = outward * (1 / length(outward));
    return side;
  }
  outward = along < full - along ? -axis.a : axis.a;
  return std::min(along, full - along);
}

template <class Real, class Use>
void FrustumCore::face(const BasicVector3<Real>& v, double margin, InstructionSet isa, const Use& use) const {
  struct Turn {
    double cosine, sine;
  };
  static const auto kTurns = [] {
    std::array<Turn, kFaceCorners> all{};
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double angle = 6.283185307179586476925 * static_cast<double>(k) / kFaceCorners;
      all[k] = {std::cos(angle), std::sin(angle)};
    }
    return all;
  }();
  const View<Real> view = look(v, isa);
  const Real least = view.height(view.index) - Real{margin};
  const Vector3& axis = shape.axis.column[0];
  const double along = dot(rounded(v), axis);
  const std::int32_t facing = along > 0 ? kTop : kBase;
  int corners = 0;
  if (std::fabs(along) > high(view.across.size) && radius_of(facing) > 0) {
    constexpr double kRounding = 0x1p-46;  // of the sums below, relative to their terms
    const Vector3 radial = any_orthogonal(axis) * radius_of(facing), tangent = cross(axis, radial),
                  w = rounded(v);
    const double middle = dot(w, center_of(facing)), by_cosine = dot(w, radial), by_sine = dot(w, tangent);
    const double swing = std::fabs(by_cosine) + std::fabs(by_sine);
    const double noise = kRounding * length(w) * (length(center_of(facing)) + radius_of(facing));
    const bool all = middle - swing > high(least) + noise;
    for (const Turn& turn : kTurns) {
      const double height = middle + by_cosine * turn.cosine + by_sine * turn.sine;
      if (!all && height < high(least) - noise) continue;
      const BasicVector3<Real> x =
          vector_of<Real>(center_of(facing)) + vector_of<Real>(radial * turn.cosine + tangent * turn.sine);
      if (!all && dot(v, x) < least) continue;
      use(x);
      ++corners;
    }
  }
  for (const std::int32_t rim : {facing, other_piece(facing)}) {
    const bool covered = rim == facing && corners == kFaceCorners;
    if (!covered && !(view.height(rim) < least)) use(view.point(rim));
  }
}

template <class Real>
bool FrustumCore::holds(const BasicVector3<Real>& x, const BasicVector3<Real>& back, double /*height*/,
                        double margin) const {
  const Axis<Real> axis(shape);
  const Real full = axis.full(shape);
  const BasicVector3<Real> from_base = x - back - vector_of<Real>(shape.base);
  const Real along = dot(from_base, axis.a) * axis.inverse, share = along / full;
  const double axis_length = std::sqrt(high(axis.square)) * high(full);
  const double edge = margin / axis_length * (1 + 0x1p-40);
  if (!(share > Real{edge}) || !(share < Real{1} - Real{edge})) return false;
  const BasicVector3<Real> radial = from_base - axis.a * along;
  const Real rise = difference<Real>(shape.top_radius, shape.base_radius);
  const Real room = rise * share + Real{shape.base_radius} - square_root(dot(radial, radial));
  return rounded(room) > margin * (2 + std::fabs(high(rise)) / axis_length);
}

}  // namespace raygauge
