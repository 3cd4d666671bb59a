// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

// What a set answers by its capabilities, and what is known where it has none.

/// The pieces of S at u; none (count = 0) without SmoothSupport.
template <class Real>
void support_pieces(const ConvexSet& S, const Real* u, BasicSupportPieces<Real>& pieces, int used = 0) {
  pieces.count = 0;
  if (const SmoothSupport* smooth = S.smooth()) smooth->pieces(u, pieces, used);
}

/// GaugeFormula::bound; +infinity without.
inline double gauge_bound(const ConvexSet& S, const double* x, double* normal) {
  const GaugeFormula* gauge = S.gauge();
  return gauge != nullptr ? gauge->bound(x, normal) : std::numeric_limits<double>::infinity();
}

/// GaugeFormula::normal; false without.
inline bool gauge_normal(const ConvexSet& S, const Quad* x, Quad* normal) {
  const GaugeFormula* gauge = S.gauge();
  return gauge != nullptr && gauge->normal(x, normal);
}

/// GaugeFormula::touches_origin; false without.
inline bool touches_origin(const ConvexSet& S, double* u) {
  const GaugeFormula* gauge = S.gauge();
  return gauge != nullptr && gauge->touches_origin(u);
}

/// FlatFaces::normal; false without.
template <class Real>
bool facet_normal(const ConvexSet& S, const Real* u, const Real* v, Real* normal) {
  const FlatFaces* faces = S.flat_faces();
  return faces != nullptr && faces->normal(u, v, normal);
}

/// CoordinateSymmetry::extents; false without.
inline bool is_unconditional(const ConvexSet& S, double* extent) {
  const CoordinateSymmetry* symmetry = S.symmetry();
  return symmetry != nullptr && symmetry->extents(extent);
}

}  // namespace raygauge
