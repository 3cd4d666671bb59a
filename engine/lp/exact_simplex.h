// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/lp/integer_scaling.h"
#include "engine/numerics/big_integer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The linear program of PrimalSimplex in exact arithmetic: the last resort where rounding keeps a
/// floating-point solve from a proof. Doubles are dyadic rationals, hence integers after scaling by powers of
/// two. The simplex is fraction-free (Edmonds; Azulay & Pique 1998): beside D = |det B| it keeps the integer
/// matrix M = D B⁻¹, so that with p = w_r, w = M c, a basis change is
///
///     M_i <- (p M_i - w_i M_r) / D  for i ≠ r,      D <- p,
///
/// divisions that leave no remainder. Degenerate vertices are left by way of a symbolic perturbation: beside
/// x = B⁻¹ b goes B⁻¹ b' with random b' that was positive at the start, and decides among equal ratios. The
/// last floating-point basis is the start, so that few changes remain; columns are priced in double-double
/// arithmetic first and exactly only where that leaves a sign in doubt.
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
  struct Basic {
    std::int64_t id = -1;
    bool artificial = true;
  };
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

  bool is_late() noexcept;
  void start_from(std::span<const std::int64_t> start);
  void make_nonnegative();
  void perturb();
  End run();
  bool reached() const;
  void compute_duals();
  void aim(bool from_Q, Direction& direction) const;
  Candidate price();
  void price_set(const Points& points, bool from_Q, Candidate& best);
  void consider(std::int64_t id, double reduced_cost, double error, Candidate& best);
  int exact_reduced_cost_sign(std::int64_t id);
  void form_column(std::int64_t id);
  void compute_w();
  int leaving_row() const;
  bool ratio_is_less(int i, int r) const;
  void replace(int r, std::int64_t id);
  std::size_t place(int i, int k) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(m_ + 1) + static_cast<std::size_t>(k);
  }

  BigInteger& M(int i, int k) { return M_[place(i, k)]; }
  const BigInteger& M(int i, int k) const { return M_[place(i, k)]; }
  const BigInteger& x(int i) const { return M(i, m_ - 1); }  // D x_i: b is the last unit vector
  BigInteger& perturbed(int i) { return M(i, m_); }          // D (B⁻¹ b')_i
  const BigInteger& perturbed(int i) const { return M(i, m_); }
  bool is_basic_from_Q(int i) const;

  Points A_;
  Points Q_;
  const Stopwatch* stopwatch_ = nullptr;
  bool late_ = false;  // the stopwatch has expired, and what is at hand may be half done
  IntegerScaling scaling_;
  int n_ = 0;
  int m_ = 0;
  Phase phase_ = Phase::reach;
  std::int64_t pivots_ = 0;
  std::vector<BigInteger> M_;  // m rows of m + 1: M and the perturbation
  BigInteger D_;
  std::vector<Basic> basic_;
  std::vector<BigInteger> column_;
  std::vector<BigInteger> w_;
  std::vector<BigInteger> Y_;  // D y
  Direction direction_;
  ExactDivisor divisor_;
  BigInteger product_;
  BigInteger other_product_;
};

}  // namespace raygauge
