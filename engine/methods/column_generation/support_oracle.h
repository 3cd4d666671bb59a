// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/kernels/kernel.h"
#include "engine/lp/column_pool.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/proof/certificate.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

class SupportPairs;

/// Support queries of one set in the solver's scaled coordinates: the set is S' = {diag(factor) p : p in S},
/// so that h_S'(u) = h_S(diag(factor) u). Point sets go straight to the vector kernels, large ones by way of
/// a working set; other sets are asked through their virtual hook.
class SupportOracle {
 public:
  /// `factor`: dimension() powers of two; nullptr for none. It must outlive the queries, and so must `pairs`,
  /// which S is asked through if it is not null.
  void bind(const ConvexSet& S, const double* factor, const Kernels& kernels, SupportPairs* pairs = nullptr);

  /// Best of the points at hand along sign · u: those of the working set for a large point set, of all of S'
  /// otherwise. The maximiser is written to `point`. At most h_S'(sign · u).
  double query(const double* u, double sign, double* point);

  /// The points at hand of a point set, and whether it is one.
  bool has_points() const noexcept { return points_ != nullptr; }
  PricedPoints points() const noexcept { return working_.view(); }

  /// Whether pass() and query_shortlist() save passes here: over point sets of many dimensions.
  bool keeps_shortlist() const noexcept;

  /// A pass over the points that query() asks, which keeps the best of every lane: eight good points.
  void pass(const double* u, double sign);

  /// As query(), over those alone.
  double query_shortlist(const double* u, double sign, double* point);

  /// h_S'(sign · u) over the whole set with a bound on its error, the maximiser in `point`. Points of a large
  /// set that beat `known` join the working set: pass what `query` returned, -infinity where it was not
  /// asked, +infinity for the value alone. For a point set the error is proven; any other set answers for
  /// ConvexSet::magnitude_unchecked: rounding_error(n) Σ|u_k| m_k.
  SupportValue verify(const double* u, double sign, double known, double* point);

  /// A bound on how far, in any coordinate, a support point is from the nearest point of S': 0 for a point
  /// set, whose support points are its own; rounding_error(n) max_k m_k for any other.
  double coordinate_error() const noexcept { return coordinate_error_; }

  /// The same in coordinate k.
  double coordinate_error(int k) const noexcept;

  /// The largest of the magnitudes m_k of S' (ConvexSet::magnitude_unchecked).
  double magnitude() const noexcept { return largest_magnitude_; }
  double magnitude(int k) const noexcept;

  /// The radius of a ball around the origin inside S'; 0 where none is known.
  double inner_radius();

  /// An upper bound on the gauge of S' at x and the outer normal there; see GaugeFormula::bound.
  double gauge(const double* x, double* normal);

  /// The scaled centre of S'.
  void center(double* point);

 private:
  SupportValue verify_points(const double* u, double sign, double known, double* point);

  const ConvexSet* set_ = nullptr;
  SupportPairs* pairs_ = nullptr;
  const PointSet* points_ = nullptr;
  const double* factor_ = nullptr;
  const Kernels* kernels_ = nullptr;
  ColumnPool working_;
  double underflow_ = 0;  // what underflow may cost: nothing where all numbers are 0, of a set that is {0}
  double coordinate_error_ = 0;
  double largest_magnitude_ = 0;
  AlignedBuffer<double> unit_;  // n ones, where no scaling is asked for
  AlignedBuffer<double> direction_;
  AlignedBuffer<double> shortlist_;  // a block
  AlignedBuffer<float> single_;
  AlignedBuffer<double> magnitude_;  // of a set that is no point set, scaled
  AlignedBuffer<std::int64_t> better_;
  AlignedBuffer<double> better_value_;
};

}  // namespace raygauge
