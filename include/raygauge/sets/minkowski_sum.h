// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A + B = {a + b : a in A, b in B}.
///
///     h(u) = h_A(u) + h_B(u),      s(u) = s_A(u) + s_B(u),      centre c_A + c_B.
class MinkowskiSum final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (null pointer) or DimensionMismatchError.
  MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B);

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  bool do_is_unconditional(double* extent) const override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  std::shared_ptr<const ConvexSet> A_;
  std::shared_ptr<const ConvexSet> B_;
};

}  // namespace raygauge
