// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/interior_sides.h"
#include "engine/lp/interior_step.h"
#include "engine/lp/whitened_points.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "engine/threads/helpers.h"

namespace raygauge {

/// The linear program of PrimalSimplex by Mehrotra's predictor-corrector method (S. Mehrotra 1992) with
/// further correctors (J. Gondzio 1996), where bases are large: some 15 factorisations of an n x n matrix
/// instead of some 10 n basis changes. Its answer
/// proves nothing; it is where the simplex starts.
///
///     maximize t   subject to   u·a_i + t + s_i = 0,   -u·q_j + s_j = 1,   s >= 0
///
/// The iterates (u, t) are strictly feasible from the start, the weights x = (α, β) become so.
class InteriorPoint {
 public:
  enum class End : std::uint8_t {
    converged,
    separated,  ///< all of Q is strictly behind the plane of normal(), and A before it
    paused,     ///< t is close to zero or far, and a proof of 0 or of infinity may do: go_on() is next
    failed,     ///< no progress, or the stopwatch
  };

  /// Over the points, from a guess of the normal's direction (n doubles).
  End solve(const PricedPoints& A, const PricedPoints& Q, int n, const double* guess, const Kernels& kernels,
            const Stopwatch& stopwatch);

  /// The same with the points after a linear map, where their own coordinates leave the equations without
  /// digits. The guess and the duals are those of the points before it.
  End solve_whitened(const WhitenedPoints& points, int n, const double* guess, const Kernels& kernels,
                     const Stopwatch& stopwatch);

  /// The last solve after End::paused, from where it is. It pauses at zero only once.
  End go_on(const Stopwatch& stopwatch);

  /// Threads that share the work of the next solves; their number does not change a bit of what is found.
  void share_with(const Helpers& helpers) noexcept { passes_.share_with(helpers); }

  /// Whether the next solves may end as paused.
  void may_pause(bool may) noexcept { may_pause_ = may; }

  /// The next solves may end as converged where t reaches `distance`, a known upper bound less a tolerance.
  void end_at(double distance) noexcept { enough_ = distance; }

  const double* normal() const noexcept { return duals_.data(); }  ///< u

  /// The duals (u, t) that maximise t: n + 1 numbers.
  const double* duals() const noexcept { return duals_.data(); }

  /// The columns that carry weight, compared with their slacks in units where d is about `unit`: those of an
  /// optimal face, however many.
  struct Carrier {
    std::int64_t id;
    double weight;
  };
  void carriers(double unit, std::vector<Carrier>& carriers) const;

  /// Whether not just n + 1 columns carry weight, nor nearly so many.
  bool is_degenerate() const { return undecided() > most_undecided(); }

  /// The n + 1 columns with the most weight at the end (identities as in PrimalSimplex): the optimal basis,
  /// if that is unique and not degenerate.
  void columns(std::vector<std::int64_t>& ids);

  std::int64_t iterations() const noexcept { return iterations_; }

 private:
  void begin(const PricedPoints& A, const PricedPoints& Q, int n, const double* guess,
             const Kernels& kernels);
  End run(const Stopwatch& stopwatch);
  End iterate(const Stopwatch& stopwatch);
  int undecided() const;
  int most_undecided() const;
  bool pauses(double gap);
  void start(const double* guess);
  bool is_separating() const;

  int n_ = 0;
  bool many_ = false;                                        // points
  double enough_ = std::numeric_limits<double>::infinity();  // of t
  int width_ = 1;                                            // of the kernels' vectors
  const WhitenedPoints* whitened_ = nullptr;                 // whose points these are, if so
  double negligible_ = 0;                                    // share of a weight that may be left out
  bool may_pause_ = false;
  bool paused_at_zero_ = false;
  double next_pause_ = 0;  // t that is far
  std::int64_t iterations_ = 0;
  std::ptrdiff_t count_ = 0;  // of points
  InteriorSides sides_;
  InteriorPasses passes_;
  InteriorStep step_;
  AlignedBuffer<double> y_;
  AlignedBuffer<double> duals_;  // y_, of the points before the map
  std::vector<std::pair<double, std::int64_t>> order_;
};

}  // namespace raygauge
