// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A set that is made of others, with whatever capabilities these give it. Derived says which, and gives one
/// text for both precisions of
///
///     is_smooth, has_flat_faces, has_gauge, has_symmetry,
///     list_pieces(u, pieces, capacity),   find_normal(u, v, normal),   find_point(normal, target, point).
template <class Derived>
class CombinedView : public ConvexSet,
                     private SmoothSupport,
                     private FlatFaces,
                     private GaugeFormula,
                     private CoordinateSymmetry {
 protected:
  explicit CombinedView(int dimension) : ConvexSet(dimension) {}

 private:
  const Derived& derived() const noexcept { return static_cast<const Derived&>(*this); }

  const SmoothSupport* do_smooth() const noexcept final { return derived().is_smooth() ? this : nullptr; }
  const FlatFaces* do_flat_faces() const noexcept final {
    return derived().has_flat_faces() ? this : nullptr;
  }
  const GaugeFormula* do_gauge_formula() const noexcept final {
    return derived().has_gauge() ? this : nullptr;
  }
  const CoordinateSymmetry* do_symmetry() const noexcept final {
    return derived().has_symmetry() ? this : nullptr;
  }

  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const final {
    derived().list_pieces(u, pieces, capacity);
  }
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const final {
    derived().list_pieces(u, pieces, capacity);
  }
  bool do_facet_normal(const double* u, const double* v, double* normal) const final {
    return derived().find_normal(u, v, normal);
  }
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const final {
    return derived().find_normal(u, v, normal);
  }
  void do_facet_point(const double* normal, const double* target, double* point) const final {
    derived().find_point(normal, target, point);
  }
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const final {
    derived().find_point(normal, target, point);
  }
};

}  // namespace raygauge
