// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "engine/kernels/kernel.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/first_basis.h"
#include "engine/lp/point_basis.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// The linear program of Example 2 over two finite sets of points,
///
///     minimize Σβ_j   subject to   Σα_i a_i - Σβ_j q_j = 0,   Σα_i = 1,   α, β >= 0,
///
/// solved by a primal simplex whose basis has n + 1 columns. Its duals (u, t) are the normal of the
/// separating hyperplane and -h_A(u); pricing is one support query of A along u and one of Q along -u.
///
/// The start needs no first phase: artificial columns ±e_k complete the first basis, at costs that put the
/// first normal where a guess wants it. In the dual they are bounds |u_k| <= cost; where one of them is
/// active at the end it is raised, and only if that does not help does a first phase decide whether any
/// multiple of Q reaches A.
class PrimalSimplex {
 public:
  enum class End : std::uint8_t {
    solved,   ///< no point prices out, or the gap over the priced points is small enough
    bounded,  ///< the same, but a bound |u_k| <= cost of an artificial column is active: raise_bounds() if no
              ///< further point prices out
    unreachable,  ///< no multiple of the priced points of Q meets those of A: the duals are a Farkas
                  ///< direction
    failed,       ///< rounding defeated every repair
    stalled,      ///< many basis changes without a gain, unless be_patient(): the optimum is degenerate
    pivot_limit,
    time_limit,
  };

  /// `gap_tolerance`: a solve may stop when its relative gap over the priced points is below. `max_pivots` as
  /// in DistanceOptions::max_iterations. `impatient`: until be_patient() a solve may end as End::stalled.
  void begin(int n, double gap_tolerance, std::int64_t max_pivots, const Kernels& kernels,
             bool impatient = false);

  /// From now on Bland's rule leads out of what would end as End::stalled.
  void be_patient() noexcept { impatient_ = false; }

  /// First basis from a guess. The points are not kept.
  void start(const ColumnPool& A, const ColumnPool& Q, const FirstGuess& guess) {
    first_.guess(A, Q, guess, basis_, loop_);
  }

  /// First basis of these n + 1 columns (FirstBasis::choose). False where there is none: start() then.
  bool start_from(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
                  const Stopwatch& stopwatch);

  /// Continues from the basis at hand. Working sets may have grown since, but not changed.
  End solve(const ColumnPool& A, const ColumnPool& Q, const Stopwatch& stopwatch);

  /// The same, but after End::solved the duals are those that the points were last priced at, and h_A, h_Q of
  /// loop() their support values. refresh_duals() of the basis makes them as good as the inverse can.
  End optimise(const ColumnPool& A, const ColumnPool& Q, const Stopwatch& stopwatch);

  /// After End::bounded: lifts the active bounds on the dual, or turns to the first phase when that has been
  /// tried often.
  void raise_bounds();

  /// After End::unreachable: the basic points of Q lie in the plane of the Farkas direction, up to rounding,
  /// which proves nothing. The next solves look for a direction that leaves all of Q strictly behind, by a
  /// margin; they end unreachable again, with it if there is one. False when that was tried before.
  bool separate();

  /// A fresh inverse, and from now on a stop at the optimal vertex only. False when nothing is left to try.
  bool repair();

  /// Repairs are counted from zero again: call when points were added.
  void allow_repairs() noexcept { repairs_ = 0; }

  /// Those of the basis; +infinity while a first phase is on.
  double proven_upper() {
    return stage_ == Stage::optimise ? basis_.proven_upper(loop_.gap_tolerance) : kInfinity;
  }
  double upper_of_moved_points(double error_A, double error_Q) {
    return stage_ == Stage::optimise ? basis_.upper_of_moved_points(error_A, error_Q) : kInfinity;
  }

  /// Brings a point of a pool (identity as in id_of_A, id_of_Q) into the basis, whose reduced cost the caller
  /// knows. False if rounding leaves no pivot.
  bool enter(const ColumnPool& pool, std::int64_t id, double reduced_cost);

  PointBasis& basis() noexcept { return basis_; }
  const PointBasis& basis() const noexcept { return basis_; }

  /// What it has priced, and how many artificial columns are basic: bounds on the normal that are active.
  const SimplexLoop& loop() const noexcept { return loop_; }

  const double* normal() const noexcept { return basis_.view().y; }  ///< u, n doubles
  /// Points of A with u·a above A price out, and points of Q with -u·q above Q.
  struct Thresholds {
    double A = 0, Q = 0;
  };
  Thresholds thresholds() const noexcept;
  double objective() const noexcept { return basis_.view().objective; }
  std::int64_t pivots() const noexcept { return basis_.view().pivots; }
  std::int64_t refactorisations() const noexcept { return refactorisations_; }

 private:
  // Phase 2 with bounded duals; phase 1; phase 1 with a margin, which is a negative cost of points of Q.
  enum class Stage : std::uint8_t { optimise, reach, separate };

  void bind(const ColumnPool& A, const ColumnPool& Q);
  bool gains(double before) const;
  void enter_stage(Stage stage);
  bool invert() {
    ++refactorisations_;
    return basis_.refactor();
  }

  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  Stage stage_ = Stage::optimise;
  int raises_ = 0;
  int separations_ = 0;
  bool impatient_ = false;
  int repairs_ = 0;
  std::int64_t max_pivots_ = 0;
  std::int64_t refactorisations_ = 0;
  PointBasis basis_;
  SimplexLoop loop_;
  FirstBasis first_;
  AlignedBuffer<double> column_;
};

/// Ends after which nothing more can be done.
bool is_final(PrimalSimplex::End end) noexcept;

}  // namespace raygauge
