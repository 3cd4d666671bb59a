// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/lp/integer_basis.h"
#include "engine/lp/integer_scaling.h"
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
  enum class End : std::uint8_t {
    solved,       ///< distance() is d_Q(A)
    unreachable,  ///< no multiple of Q meets A: normal() is a Farkas direction
    stopped,      ///< by the stopwatch, in the middle of anything, or by the pivot limit; nothing is known
    too_long,     ///< not begun: what it is expected to take is more than the stopwatch leaves
  };

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
  enum class Phase : std::uint8_t { reach, optimise };
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

  void start_from(std::span<const std::int64_t> start);
  End run();
  void compute_duals();
  void aim(bool from_Q, Direction& direction) const;
  Candidate price();
  void price_set(const Points& points, bool from_Q, Candidate& best);
  int exact_reduced_cost_sign(std::int64_t id);
  void form_column(std::int64_t id);
  void enter(int row, std::int64_t id);

  Points A_;
  Points Q_;
  Deadline deadline_;  // when it is over, what is at hand may be half done
  IntegerScaling scaling_;
  int n_ = 0;
  int m_ = 0;
  Phase phase_ = Phase::reach;
  std::int64_t pivots_ = 0;
  IntegerBasis basis_;
  std::vector<BigInteger> column_;
  std::vector<BigInteger> Y_;  // D y
  Direction direction_;
};

}  // namespace raygauge
