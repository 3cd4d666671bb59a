// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/combined_view.h"

namespace raygauge {

class BoundedInverse;

/// x ↦ M x + t, M n × n by columns, with what is known of its inverse. All must outlive their use.
struct LinearMap {
  int n = 0;
  const double* M = nullptr;
  const double* t = nullptr;
  const BoundedInverse* inverse = nullptr;  ///< nullptr for a rotation: its inverse is Mᵀ, up to the defect
  double defect = 0;                        ///< of a rotation: at least ‖MᵀM - 1‖ in the spectral norm
  bool exchanges_axes = false;              ///< each row and each column of M has one entry that is not 0
  bool reverses_axes = false;               ///< the same, and these entries are 1 or -1
};

/// {M x + t : x in S}, a view of S, M and t, which must outlive it.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
///
/// What S offers beyond its support function is kept: pieces and flat faces always, its gauge where t = 0. A
/// proof that it touches the origin, and symmetry about the axes, are kept where M only exchanges, reverses
/// and scales the axes.
class LinearImage : public CombinedView<LinearImage> {
 public:
  LinearImage(const ConvexSet& S, const LinearMap& map) : CombinedView(map.n), S_(&S), map_(map) {}

  bool is_smooth() const noexcept { return S_->smooth() != nullptr; }
  bool has_flat_faces() const noexcept;
  bool has_gauge() const noexcept;
  bool has_symmetry() const noexcept;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_point(const Real* normal, const Real* target, Real* point) const;

 private:
  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const final;
  void do_magnitude(double* magnitude) const final;
  double do_inner_radius(const double* c) const final;
  SupportStructure do_structure() const noexcept final { return S_->structure(); }
  double do_gauge(const double* x, double* normal) const final;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const final;
  bool do_touches_origin(double* u) const final;
  bool do_is_unconditional(double* extent) const final;

  const ConvexSet* S_;
  LinearMap map_;
};

}  // namespace raygauge
