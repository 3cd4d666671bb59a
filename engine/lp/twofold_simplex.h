// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/twofold_basis.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// As PointBasis, in double-double arithmetic.
class TwofoldPointBasis : public TwofoldBasis {
 public:
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
};

/// The linear program of PrimalSimplex in double-double arithmetic: for bases whose condition, 10¹⁵ and more,
/// leads the simplex in doubles astray and leaves nothing of its proofs, at a small share of what exact
/// arithmetic costs. Bounds |u_k| are not needed: artificial columns with weight are driven out in a first
/// phase of their own. It starts from the last basis of the simplex in doubles.
class TwofoldSimplex {
 public:
  enum class End : std::uint8_t {
    solved,       ///< no point prices out, or the gap is small enough
    unreachable,  ///< no multiple of Q meets A: the duals are a Farkas direction that leaves Q behind by a
                  ///< margin
    failed,       ///< not even these digits decide
    stopped,      ///< by the stopwatch, in the middle of anything
  };

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
  // As the stages of PrimalSimplex; the margin is a negative cost of points of Q.
  enum class Phase : std::uint8_t { reach, separate, optimise };
  struct Entering {
    std::int64_t id = -1;
    double h_A = 0, h_Q = 0;
  };

  void begin(const Points& A, const Points& Q, double gap_tolerance, const Kernels& kernels,
             const Stopwatch& stopwatch);
  bool start_from(std::span<const std::int64_t> start);
  void begin_phase();
  bool has_reached() const;
  bool has_drifted() const;
  void enter_phase(Phase phase);
  double cost(int i) const;
  double cost_of_Q() const noexcept;
  double dual_length() const;
  void turn_to_next_phase();
  void form_column(std::int64_t id);
  double price(const Points& points, double sign, std::ptrdiff_t* index);
  Entering price_all();
  bool gap_is_closed(const Entering& priced) const;
  double noise(int i) const { return noise_[static_cast<std::size_t>(i)]; }
  void measure_noise();
  int leaving_row() const;
  bool enter(std::int64_t id);

  Points A_, Q_;
  const Kernels* kernels_ = nullptr;
  const Stopwatch* stopwatch_ = nullptr;
  int n_ = 0;
  int m_ = 0;
  Phase phase_ = Phase::reach;
  double gap_tolerance_ = 0;
  double margin_ = 0;  // of Phase::separate
  std::int64_t pivots_ = 0;
  std::int64_t points_priced_ = 0;
  TwofoldPointBasis basis_;
  AlignedBuffer<double> column_, y_, y_low_, u_, u_low_, values_, cost_;
  AlignedBuffer<double> noise_;  // of the entries of x and w: rounding
};

}  // namespace raygauge
