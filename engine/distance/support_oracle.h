// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/distance/aligned_buffer.h"
#include "engine/distance/certificate.h"
#include "engine/kernel/kernel.h"
#include "engine/sets/point_set.h"

namespace raygauge {

/// Support queries of one set in the solver's scaled coordinates: the set is S' = {diag(factor) p : p in S},
/// so that h_S'(u) = h_S(diag(factor) u). Point sets go straight to the vector kernels; other sets through
/// their virtual hook.
class SupportOracle {
 public:
  /// `factor`: dimension() powers of two; nullptr for none. It must outlive the queries.
  void bind(const ConvexSet& S, const double* factor, const Kernels& kernels);

  /// h_S'(sign · u), with the maximiser written to `point`.
  double query(const double* u, double sign, double* point);

  /// h_S'(sign · u) with a bound on its error. For a point set the bound is proven; for any other set it is
  /// the accuracy asked of a support function: (n + 4) rounding units of Σ|u_k s_k|.
  SupportValue query_with_error(const double* u, double sign, double* point);

  /// The scaled centre of S'.
  void center(double* point);

 private:
  void scale_direction(const double* u, double sign);
  void scale_point(double* point) const;

  const ConvexSet* set_ = nullptr;
  const PointSet* points_ = nullptr;
  const double* factor_ = nullptr;
  const Kernels* kernels_ = nullptr;
  AlignedBuffer<double> direction_;
};

}  // namespace raygauge
