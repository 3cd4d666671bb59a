// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/lp/column_pool.h"
#include "engine/lp/primal_simplex.h"
#include "engine/lp/scaling.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/proof/certificate.h"
#include "engine/threads/chunk_team.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// Two point sets brought to magnitude 1, the points of them that a linear program is solved over, and passes
/// over all their points: the lower bound that a normal proves, and which points it leaves on the wrong side.
class WorkingSets {
 public:
  /// Points above a threshold.
  struct Violators {
    Collection points;  // new ones above it, and those as near below it as `reach`
    bool any = false;   // whether one is above
    double reach = 0;
  };

  struct Side {
    const PointSet* set = nullptr;
    const double* factor = nullptr;        // n powers of two: what the coordinates are scaled by
    ColumnPool pool;                       // the working set
    std::span<const std::int64_t> chosen;  // the points that may be used; none given: all
    SupportValue h;                        // of the last pass, along the direction at hand
    Violators violators;                   // of the last price()
    std::int64_t own_index(std::ptrdiff_t i) const { return pool.index_in(*set, factor, i); }
  };

  void begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options);

  /// All points of small sets, samples of large ones; or some points, given by their indices.
  void choose();
  void choose(std::span<const std::int64_t> chosen_A, std::span<const std::int64_t> chosen_Q);

  const Side& A() const noexcept { return A_; }
  const Side& Q() const noexcept { return Q_; }
  int n() const noexcept { return n_; }
  const Kernels& kernels() const noexcept { return *kernels_; }
  Helpers helpers() noexcept { return {team_, threads_}; }
  int distance_shift() const noexcept { return scaling_.distance_shift(); }  ///< see Scaling
  DistanceCounters& counters() noexcept { return counters_; }

  bool is_complete() const noexcept { return A_.pool.is_complete() && Q_.pool.is_complete(); }
  bool is_restricted() const noexcept { return !A_.chosen.empty(); }

  /// u for A, then -u for Q, in the sets' own units: 2n numbers, those of the last pass. Before the first
  /// one, room for a guess of u.
  double* direction() noexcept { return direction_.data(); }

  /// The lower bounds on the (scaled) distance that a normal y proves, n numbers, from a pass over both sets.
  /// `price`: that of the program, and the points that price out; `roughly`: with no more than the plain
  /// bound on rounding errors.
  double bound(const double* y);
  double price(const PrimalSimplex& program, bool roughly);

  /// The normal y + y_low in twice the precision, and the points that attain h_A(u) and h_Q(-u).
  double bound_twofold(const double* y, const double* y_low, std::int64_t* best_A, std::int64_t* best_Q);

  /// Of complete sets in place: by the support values that the program has just priced with, without a pass.
  std::optional<double> bound_as_priced(const PrimalSimplex& program);

  /// Takes a normal that has left Q behind, of sets that no multiple joins.
  void take_plane(const double* y);

  bool has_violators() const noexcept { return A_.violators.any || Q_.violators.any; }
  void add_violators();

  /// u·p of the points of a pool, until the next call; in twice the precision with `u_low`.
  const double* products(const ColumnPool& pool, const double* u, const double* u_low = nullptr);

  /// A (scaled) point of A in its own units.
  void to_own_units(double* point) const noexcept;

 private:
  void aim(const double* y) noexcept;
  void price_side(Side& side, const double* direction, double threshold, double resolution);

  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  double tolerance_ = 0;
  int threads_ = 1;
  ChunkTeam team_;
  Scaling scaling_;
  Side A_, Q_;
  DistanceCounters counters_;
  AlignedBuffer<double> direction_;
  AlignedBuffer<double> direction_low_;  // what it is short of, in twice the precision
  AlignedBuffer<std::int64_t> collected_;
  AlignedBuffer<double> collected_value_;
};

}  // namespace raygauge
