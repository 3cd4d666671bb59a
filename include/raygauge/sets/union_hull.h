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
class UnionHull final : public ConvexSet {
 public:
  /// Throws EmptySetError (m = 0), InvalidParameterError (null pointer) or DimensionMismatchError.
  explicit UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets);

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  std::vector<std::shared_ptr<const ConvexSet>> sets_;
};

}  // namespace raygauge
