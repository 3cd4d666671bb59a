// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// conv(S_1 ∪ … ∪ S_m), the convex hull of a union.
///
///     h(u) = max_i h_i(u),      s(u) = s_i(u) for the smallest maximising i,      centre: the mean of the
///     c_i.
class UnionHull final : public ConvexSet,
                        private SmoothSupport,
                        private FlatFaces,
                        private GaugeFormula,
                        private CoordinateSymmetry {
 public:
  /// Throws EmptySetError (m = 0), InvalidParameterError (null pointer) or DimensionMismatchError.
  explicit UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets);

  const std::vector<std::shared_ptr<const ConvexSet>>& sets() const noexcept { return sets_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override;
  const FlatFaces* do_flat_faces() const noexcept override;
  const GaugeFormula* do_gauge_formula() const noexcept override;
  const CoordinateSymmetry* do_symmetry() const noexcept override;

  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;
  bool do_facet_normal(const double* u, const double* v, double* normal) const override;
  void do_facet_point(const double* normal, const double* target, double* point) const override;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const override;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const override;
  double do_gauge(const double* x, double* normal) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  bool do_touches_origin(double* u) const override;
  bool do_is_unconditional(double* extent) const override;

  template <class Real>
  const ConvexSet& outermost(const Real* u) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  std::vector<std::shared_ptr<const ConvexSet>> sets_;
};

}  // namespace raygauge
