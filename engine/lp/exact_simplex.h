// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/lp/integer_basis.h"
#include "engine/lp/integer_scaling.h"
#include "engine/lp/simplex_phases.h"
#include "engine/numerics/big_integer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The linear program of PrimalSimplex in exact arithmetic: the last resort where rounding keeps a
/// floating-point solve from a proof. Doubles are dyadic rationals, hence integers after scaling by powers of
/// two (IntegerBasis). The last floating-point basis is the start, so that few changes remain; columns are
/// priced in double-double arithmetic first and exactly only where that leaves a sign in doubt.
class ExactSimplex {
 public:
  using End = SimplexEnd;  ///< solved: distance() is d_Q(A); unreachable: normal() is a Farkas direction

  /// Points of S that may be used; all of them if `chosen` is empty.
  struct Points {
    const PointSet* set = nullptr;
    std::span<const std::int64_t> chosen;
  };

  /// Solves for the points given, starting from the basic columns `start` (identities as in id_of_A, id_of_Q
  /// with indices into the sets; negative ones are passed over). Not begun if it is expected to take more
  /// than `most_seconds`.
  End solve(const Points& A, const Points& Q, std::span<const std::int64_t> start, const Stopwatch& stopwatch,
            double most_seconds = std::numeric_limits<double>::infinity());

  /// What a solve in R^n of coordinates of `bits` bits may be expected to take, in seconds: the basis is
  /// built from n + 1 columns, at each of which (n + 1)² determinants grow by `bits` bits.
  static double expected_seconds(int n, double bits) noexcept;

  RoundedRatio distance() const;        ///< Σβ of the last basis
  void normal(double* u) const;         ///< rounded; scaled to h_Q(-u) = 1 where that is positive
  void contact_point(double* p) const;  ///< Σα_i a_i of the last basis, rounded
  /// The points of A in the last basis with positive weights, as (index, weight rounded).
  void weights_of_A(std::vector<PointWeight>& weights) const;
  std::int64_t pivots() const noexcept { return pivots_; }

 private:
  // constant + Σ_k factor_k (unit_k p_k) with powers of two unit_k that bring the coordinates p_k of a set
  // below 1.
  struct Direction {
    std::vector<DoubleDouble> factor;
    std::vector<double> unit;
    DoubleDouble constant;
    double rough(const double* p) const;
    double precise(const double* p) const;
  };
  struct Candidate {
    std::int64_t id = -1;
    double reduced_cost = 0;  // relative to the largest term in it
  };

  // What run_phases asks; prices are always as good as new.
  template <class Program>
  friend SimplexEnd run_phases(Program& program, std::int64_t most_pivots);
  SimplexPhase phase() const noexcept { return phase_; }
  void begin(SimplexPhase phase) noexcept { phase_ = phase; }
  bool has_reached() const { return basis_.has_reached(); }
  bool is_late() noexcept { return deadline_.is_over(); }
  static bool refresh() noexcept { return false; }
  static bool separate() noexcept { return false; }
  std::int64_t price();
  bool enter(std::int64_t id);
  bool replace(int row, std::int64_t id);

  void start_from(std::span<const std::int64_t> start);
  void compute_duals();
  void aim(bool from_Q, Direction& direction) const;
  void price_set(const Points& points, bool from_Q, Candidate& best);
  int exact_reduced_cost_sign(std::int64_t id);
  void form_column(std::int64_t id);

  Points A_;
  Points Q_;
  Deadline deadline_;  // when it is over, what is at hand may be half done
  IntegerScaling scaling_;
  int n_ = 0;
  int m_ = 0;
  SimplexPhase phase_ = SimplexPhase::reach;
  std::int64_t pivots_ = 0;
  IntegerBasis basis_;
  std::vector<BigInteger> column_;
  std::vector<BigInteger> Y_;  // D y
  Direction direction_;
};

}  // namespace raygauge
