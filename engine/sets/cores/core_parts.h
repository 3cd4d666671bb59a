// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/numerics/real.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/numerics/instruction_set.h"

namespace raygauge {

inline constexpr std::int32_t kSmoothPiece = -1;  ///< the index of a core without vertices and edges

/// Of a piece of a support function at u: its Hessian is share (S - y yᵀ), S the form of the core.
struct CoreCurvature {
  Vector3 y;
  double share = 0;
};

/// A flat disc of a core: its index, outward unit normal, centre and radius.
struct CoreDisc {
  std::int32_t index = 0;
  Vector3 normal, center;
  double radius = 0;
};

/// The vertices between which a point of a core without area is, the nearer one first, and how much of the
/// point is that one. 0 of other cores.
struct CoreEnds {
  int count = 0;
  std::int32_t index[2] = {0, 0};
  double share = 1;
};

/// A direction v as a core of vertices sees it: the index of the highest one, points and heights v·x of any.
template <class Core, class Real>
struct VertexView {
  const Core& core;
  const BasicVector3<Real>& v;
  std::int32_t index;

  BasicVector3<Real> point(std::int32_t i) const { return vector_of<Real>(core.vertex(i)); }
  Real height(std::int32_t i) const { return dot(v, core.vertex(i)); }
};

/// Calls use(x) for every vertex of a core that is within `margin` of the highest one along v.
template <class Core, class Real, class Use>
void for_vertices_near_top(const Core& core, const BasicVector3<Real>& v, double margin, InstructionSet isa,
                           const Use& use) {
  const auto view = core.look(v, isa);
  const Real least = view.height(view.index) - Real{margin};
  const auto count = static_cast<std::int32_t>(core.vertex_count());
  for (std::int32_t i = 0; i < count; ++i) {
    if (!(view.height(i) < least)) use(view.point(i));
  }
}

}  // namespace raygauge
