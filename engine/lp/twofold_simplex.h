// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/simplex_phases.h"
#include "engine/lp/twofold_basis.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// As PointBasis, in double-double arithmetic.
class TwofoldPointBasis : public TwofoldBasis {
 public:
  /// What rounding may have done to x_i and w_i, from the inverse at hand.
  void measure_noise();
  double noise(int i) const { return noise_[static_cast<std::size_t>(i)]; }

  /// No artificial column has weight.
  bool has_reached() const;

  /// By Harris' two-pass ratio test; with `at_zero`, an artificial column that has reached zero must stay
  /// there: it leaves at the first chance. -1 where rounding leaves no pivot.
  int leaving_row(bool at_zero) const;

  /// Σβ of the exact basic solution, rounded up, where its weights are proven to be positive or exactly zero
  /// (columns_span); 0 only where it is exactly 0. +infinity where nothing is proven.
  double upper(const Stopwatch& stopwatch);

  /// Of the solution of the last upper(), as computed: Σβ, the point Σα_i a_i scaled as the points are, and
  /// the points of A with positive weights.
  double objective() const noexcept { return objective_; }
  void contact_point(double* point) const;
  void weights_of_A(std::vector<PointWeight>& weights) const;

 private:
  bool is_point_of_A(int i) const { return !is_artificial(i) && !is_from_Q(id(i)); }
  bool are_zero(const Stopwatch& stopwatch);

  Solution solution_;
  double objective_ = 0;
  std::vector<int> zeros_;       // positions of weights that are zero, in solution_
  std::vector<double> columns_;  // at the others
  AlignedBuffer<double> noise_;
};

/// The linear program of PrimalSimplex in double-double arithmetic: for bases whose condition, 10¹⁵ and more,
/// leads the simplex in doubles astray and leaves nothing of its proofs, at a small share of what exact
/// arithmetic costs. Bounds |u_k| are not needed: artificial columns with weight are driven out in a first
/// phase of their own. It starts from the last basis of the simplex in doubles.
class TwofoldSimplex {
 public:
  using End = SimplexEnd;

  /// The points of a set, times a power of two for each coordinate.
  struct Points {
    const PointSet* set = nullptr;
    const double* factor = nullptr;
  };

  /// `start`: basic columns to begin with (identities as in id_of_A, id_of_Q with indices into the sets;
  /// negative ones are passed over). A solve may stop when its relative gap is below `gap_tolerance`.
  End solve(const Points& A, const Points& Q, std::span<const std::int64_t> start, double gap_tolerance,
            const Kernels& kernels, const Stopwatch& stopwatch);

  /// After End::solved. The duals (u, t) of the basis are y + y_low: n + 1 numbers each.
  const double* normal() const noexcept { return y_.data(); }
  const double* normal_low() const noexcept { return y_low_.data(); }

  /// Where its upper bounds come from.
  TwofoldPointBasis& basis() noexcept { return basis_; }

  std::int64_t pivots() const noexcept { return pivots_; }
  std::int64_t points_priced() const noexcept { return points_priced_; }

 private:
  struct Entering {
    std::int64_t id = -1;
    double h_A = 0, h_Q = 0;
  };

  // What run_phases asks.
  template <class Program>
  friend SimplexEnd run_phases(Program& program, std::int64_t most_pivots);
  SimplexPhase phase() const noexcept { return phase_; }
  void begin(SimplexPhase phase);
  bool has_reached() const { return basis_.has_reached(); }
  bool is_late() const { return stopwatch_->expired(); }
  bool refresh();
  bool separate();
  std::int64_t price();
  bool enter(std::int64_t id);

  void bind(const Points& A, const Points& Q, double gap_tolerance, const Kernels& kernels,
            const Stopwatch& stopwatch);
  bool start_from(std::span<const std::int64_t> start);
  void begin_anew();
  bool has_drifted() const;
  double cost(int i) const;
  double cost_of_Q() const noexcept;
  double dual_length() const;
  void form_column(std::int64_t id);
  double price_set(const Points& points, double sign, std::ptrdiff_t* index);
  bool gap_is_closed(const Entering& priced) const;

  Points A_, Q_;
  const Kernels* kernels_ = nullptr;
  const Stopwatch* stopwatch_ = nullptr;
  int n_ = 0;
  int m_ = 0;
  SimplexPhase phase_ = SimplexPhase::reach;
  double gap_tolerance_ = 0;
  double margin_ = 0;  // of SimplexPhase::separate
  std::int64_t pivots_ = 0;
  std::int64_t fresh_ = 0;  // pivots at the last factorisation
  std::int64_t points_priced_ = 0;
  TwofoldPointBasis basis_;
  AlignedBuffer<double> column_, y_, y_low_, u_, u_low_, values_, cost_;
};

}  // namespace raygauge
