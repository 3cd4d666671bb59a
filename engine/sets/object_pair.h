// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/aligned_buffer.h"
#include "engine/sets/minkowski_view.h"

namespace raygauge {

/// A2 - A1 as MinkowskiDifference has it, of two sets that it only looks at for the time of one solve.
class ObjectPair final : public MinkowskiView {
 public:
  /// `keeps_parts`: closest points of A1 and A2 are asked for, which the combination of a solve has to be
  /// taken apart for (SupportPairs). Throws DimensionMismatchError.
  ObjectPair(const ConvexSet& A2, const ConvexSet& A1, bool keeps_parts);

  const ConvexSet& A2() const noexcept { return *sum().S; }
  const ConvexSet& A1() const noexcept { return *sum().T; }
};

/// Asks an ObjectPair in place of a solver, with the same answers, and notes the point a1 of A1 in each point
/// a2 - a1 that the pair answers with. One solve's own: the pair itself is as constant as any set.
class SupportPairs {
 public:
  /// From now on of this pair, which must outlive the queries. Nothing is noted yet.
  void begin(const ObjectPair& pair);

  /// ConvexSet::support_unchecked.
  double support(const double* u, double* point);

  /// SmoothSupport::pieces; none (count = 0) without it.
  template <class Real>
  void pieces(const Real* u, BasicSupportPieces<Real>& pieces);

  /// FlatFaces::point.
  template <class Real>
  void facet_point(const Real* normal, const Real* target, Real* point);

  /// The a1 of the difference nearest to this one, which is a noted one, perhaps after a multiplication by
  /// one; nullptr if nothing was noted.
  const double* partner(const double* difference) const;

 private:
  template <class Real>
  void add(const Real* difference, const Real* a1);

  const ObjectPair* pair_ = nullptr;
  int n_ = 0;
  std::ptrdiff_t count_ = 0;
  AlignedBuffer<double> pairs_;  // difference, then a1
};

}  // namespace raygauge
