// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/cores/box_core.h"
#include "engine/sets/cores/ellipsoid_core.h"
#include "engine/sets/cores/frustum_core.h"
#include "engine/sets/cores/point_core.h"
#include "engine/sets/cores/points_core.h"
#include "engine/sets/cores/segment_core.h"

namespace raygauge {

/// Calls `use` with the core of a shape, one of the structs of this folder, each over both number types:
///
/// - vertex_count(), vertex(i): without rounding; a curved core has none
/// - look(v, isa): a direction as the core sees it: `index` of the highest piece (a vertex from 0 on, or a
///   smooth piece below 0), and of any piece point(i) and height(i)
/// - face(v, margin, isa, use): calls use(x) for points x, at most `margin` below the highest along v, whose
///   hull is what the core has of a face there
/// - half_axes(): those of an ellipsoid about like the core
///
/// and what it can beyond that, which is asked by `requires`:
///
/// - form(axis), curvature(axis, u, i): of a curved core with its axes in any frame: the Hessian of piece i
///   at u is share (form - y yᵀ)
/// - nearest(y): the point of the core nearest to y; y itself inside
/// - way_out(y, outward): of a point y inside: how far it is to the surface, and the unit normal there
/// - holds(x, back, height, margin): whether the ball of radius `margin` about x - back is inside for
///   certain; x is highest for some unit vector v, and v·back is `height`
/// - top_of_rim(v, i): the highest point of rim i along v
/// - ends_around(x): of a core without area: the vertices between which x is
/// - generators(use): calls use(g) for the half edges whose segments [-g, g] add up to the core
/// - top(v, tilt, end): of a core that is not smooth: see count_highest()
/// - disc(v): the flat disc on the side of v
///
/// This is the only place that tells kinds apart.
template <class Use>
[[gnu::always_inline]] inline decltype(auto) with_core(const SpatialShape& shape, const Use& use) {
  switch (shape.kind) {
    case SpatialShape::Kind::segment:
      return use(SegmentCore{shape});
    case SpatialShape::Kind::box:
      return use(BoxCore{shape});
    case SpatialShape::Kind::ellipsoid:
      return use(EllipsoidCore{shape});
    case SpatialShape::Kind::frustum:
      return use(FrustumCore{shape});
    case SpatialShape::Kind::points:
      return use(PointsCore{shape});
    case SpatialShape::Kind::point:
      break;
  }
  return use(PointCore{shape});
}

/// 0 of a curved core.
inline std::ptrdiff_t count_vertices(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) { return core.vertex_count(); });
}
inline bool is_point(const SpatialShape& shape) { return shape.kind == SpatialShape::Kind::point; }
/// Whether it has area, and a formula for the point nearest to another one.
inline bool has_projection(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) {
    return requires(Vector3 y) { core.nearest(y); }
    &&!requires(Vector3 x) { core.ends_around(x); };
  });
}
/// conv of two ends, or a point.
inline bool is_between_ends(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) {
    return requires(Vector3 x) { core.ends_around(x); };
  });
}
inline bool is_curved(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) {
    return requires { core.kIsCurved; };
  });
}
/// Without an edge.
inline bool is_smooth(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) {
    return requires { core.kIsSmooth; };
  });
}
/// Whether the Hessian of its support function has rank 2.
inline bool has_curved_surface(const SpatialShape& shape) { return is_curved(shape) && is_smooth(shape); }
inline bool has_discs(const SpatialShape& shape) {
  return with_core(shape, [](const auto& core) {
    return requires(Vector3 v) { core.disc(v); };
  });
}
inline CoreDisc disc_towards(const SpatialShape& shape, const Vector3& v) {
  return with_core(shape, [&v](const auto& core) {
    if constexpr (requires { core.disc(v); }) return core.disc(v);
    return CoreDisc{};
  });
}

/// Calls use(g) for the generators of a core; false where it is no sum of segments.
template <class Use>
bool for_generators(const SpatialShape& shape, const Use& use) {
  return with_core(shape, [&use](const auto& core) {
    if constexpr (requires { core.generators(use); }) {
      core.generators(use);
      return true;
    }
    return false;
  });
}

/// Of a core with two smooth pieces the other one; of others the same.
inline std::int32_t other_piece(const SpatialShape& shape, std::int32_t piece) {
  return with_core(shape, [piece](const auto& core) {
    if constexpr (requires { core.other_piece(piece); }) return core.other_piece(piece);
    return piece;
  });
}

/// 1 where one point of a core is the highest along any direction within `tilt` of v, of length 1; 2: the
/// ends of an edge, which are written. All others are lower there for certain. 0: more, or not known.
[[gnu::always_inline]] inline int count_highest(const SpatialShape& shape, const Vector3& v, double tilt,
                                                Vector3 (&end)[2]) {
  return with_core(shape, [&](const auto& core) {
    if constexpr (requires { core.kIsSmooth; })
      return 1;
    else
      return core.top(v, tilt, end);
  });
}

/// Whether one point of the core is the highest along v, of length 1, and along all directions within about
/// `tilt` of it: no edge and no face is across v. For rounding errors of v.
inline bool has_one_top(const SpatialShape& shape, const Vector3& v, double tilt, InstructionSet isa) {
  return with_core(shape, [&](const auto& core) {
    if constexpr (requires { core.kIsSmooth; }) return true;
    if constexpr (requires { core.disc(v); }) {
      const CoreDisc disc = core.disc(v);
      const Vector3 across = v - disc.normal * dot(v, disc.normal);
      if (disc.radius > 0 && !(dot(across, across) > tilt * tilt)) return false;
    }
    const Vector3 e = any_orthogonal(v) * tilt, f = cross(v, e);
    const std::int32_t top = core.look(v + e, isa).index;
    constexpr double kThird = 0.866025403784438646763;
    return core.look(v - e * 0.5 + f * kThird, isa).index == top &&
           core.look(v - e * 0.5 - f * kThird, isa).index == top;
  });
}

/// A vertex without rounding, in the frame of the core; of a curved core its centre.
inline Vector3 vertex_of(const SpatialShape& shape, std::int32_t index) {
  return with_core(shape, [index](const auto& core) { return core.vertex(index); });
}

}  // namespace raygauge
