// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "engine/lp/column_pool.h"
#include "engine/lp/gauge_bound.h"
#include "engine/lp/primal_simplex.h"
#include "engine/methods/column_generation/support_oracle.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// The method `column_generation` on any convex sets that are known through their support mappings: the
/// program over the support points met so far (PrimalSimplex) is solved, its normal asks each set for one
/// more support point, and the certificates
///
///     -h_A(u) / h_Q(-u)  <=  d_Q(A)  <=  Σβ_j
///
/// close in on each other. On a polytope this ends after finitely many rounds. All values are in the oracles'
/// scaled coordinates.
class SupportColumnGeneration {
 public:
  /// The oracles are the caller's and must outlive the solve. `threshold`: see Problem.
  void begin(SupportOracle& A, SupportOracle& Q, int n, const DistanceOptions& options,
             const Kernels& kernels, double threshold = Goal().threshold);

  /// Makes a support point known beforehand.
  void offer_A(const double* point) { points_A_.add(point); }
  void offer_Q(const double* point) { points_Q_.add(point); }

  std::ptrdiff_t offered() const noexcept { return points_A_.size(); }

  /// Asks the oracles until the gap is within the tolerance, or a limit is reached.
  DistanceStatus run(const Stopwatch& stopwatch);

  /// Solves the program over the offered points alone and proves an upper bound from it.
  void solve_offered(const double* guess, const Stopwatch& stopwatch);

  Bounds bounds() const noexcept { return {lower_, upper_}; }
  const double* normal() const noexcept { return normal_.data(); }    ///< direction of the lower bound
  const PrimalSimplex& program() const noexcept { return program_; }  ///< over the points met so far
  const DistanceCounters& counters();

 private:
  void ask(const double* u);
  struct Best {  // of the rounds so far
    double lower = -1;
    double upper = std::numeric_limits<double>::infinity();
    double objective = std::numeric_limits<double>::infinity();
    int idle_rounds = 0;  // since one of these was bettered
  };
  void start();
  DistanceStatus iterate(const Stopwatch& stopwatch);
  void take_upper_bound(PrimalSimplex::End end, const Stopwatch& stopwatch);
  int note_progress(PrimalSimplex::End end, Best& best) const;
  bool offer_support_points();
  bool prepare_next(PrimalSimplex::End end);
  void ask_gauge(const double* x);
  double gauge_of_rounding();
  bool closes_by_gauge();
  double gauge_per_residual(const Stopwatch& stopwatch);
  double surround_origin(SupportOracle& S, ColumnPool& points, const Stopwatch& stopwatch);
  bool holds_origin(const Stopwatch& stopwatch);
  double upper_despite_residual(const Stopwatch& stopwatch);
  double upper_of_the_sets(double upper_of_the_points, const Stopwatch& stopwatch);

  SupportOracle* A_ = nullptr;
  SupportOracle* Q_ = nullptr;
  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  Goal goal_;
  PrimalSimplex program_;
  GaugeBound gauge_bound_;
  double gauge_per_residual_ = 0;  // of gauge_bound_; 0: not computed
  double moved_upper_ = 0;         // proven by a basis whose weights stay positive when rounding moves points
  ColumnPool points_A_;
  ColumnPool points_Q_;
  SupportValue h_A_;
  SupportValue h_Q_;
  AlignedBuffer<double> point_A_;
  AlignedBuffer<double> point_Q_;
  AlignedBuffer<double> normal_;
  AlignedBuffer<double> axis_;  // and the support point along it
  WeightedPoints contact_;
  double lower_ = 0;
  double upper_ = 0;
  DistanceCounters counters_;
};

}  // namespace raygauge
