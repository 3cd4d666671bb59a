// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raygauge/sets/pose.h"

namespace raygauge {

/// {R x + t : x in S}, a set in a pose, for the time of a query: neither is copied and nothing is allocated.
///
///     h(u) = h_S(Rᵀu) + u·t,      s(u) = R s_S(Rᵀu) + t,      centre R c_S + t.
///
/// What S offers beyond its support function is kept: a rotation changes no structure, its inverse is its
/// transpose. What needs S where it stands (its gauge, a proof that it touches the origin, symmetry about the
/// axes) is kept where R and t leave that alone.
class PosedView final : public ConvexSet {
 public:
  /// Throws DimensionMismatchError.
  PosedView(const ConvexSet& S, const Pose& pose);

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  double do_gauge(const double* x, double* normal) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  bool do_touches_origin(double* u) const override;
  SupportStructure do_structure() const noexcept override { return S_.structure(); }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  bool do_facet_normal(const double* u, const double* v, double* normal) const override;
  void do_facet_point(const double* normal, const double* target, double* point) const override;
  bool do_is_unconditional(double* extent) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const override;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const override;

  bool is_translated() const noexcept;
  template <class Real>
  void turn(const Real* x, int stride, Real* image) const noexcept;
  template <class Real>
  void turn_back(const Real* u, Real* inner) const noexcept;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_facet_point(const Real* normal, const Real* target, Real* point) const;

  const ConvexSet& S_;
  const Pose& pose_;
};

/// A posed set as one set: the set itself where it has no pose, otherwise a view held here.
class InPose {
 public:
  explicit InPose(const Posed& posed) : set_(&posed.set) {
    if (posed.pose != nullptr) set_ = &view_.emplace(posed.set, *posed.pose);
  }
  InPose(const InPose&) = delete;
  InPose& operator=(const InPose&) = delete;

  const ConvexSet& set() const noexcept { return *set_; }

 private:
  const ConvexSet* set_;
  std::optional<PosedView> view_;
};

}  // namespace raygauge
