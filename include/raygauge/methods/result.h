// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "raygauge/methods/options.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Numerical outcomes of a solve. In every case lower <= d_Q(A) <= upper holds.
enum class DistanceStatus : std::uint8_t {
  optimal,          ///< upper - lower <= tolerance * upper
  contains_origin,  ///< 0 in A, proven: d = 0
  unreachable,      ///< no multiple of Q meets A, proven by a Farkas direction (normal): d = +infinity
  precision_limit,  ///< the bounds hold but could not be brought within the tolerance
  iteration_limit,  ///< stopped by DistanceOptions::max_iterations
  time_limit,       ///< stopped by DistanceOptions::time_limit
};

/// "optimal", "contains_origin", …: the names used in JSON and in results files.
std::string_view to_string(DistanceStatus status) noexcept;

/// The inverse of to_string. Throws UnknownNameError.
DistanceStatus distance_status_from_string(std::string_view name);

/// Work done in a solve, summed over all methods that took part. Counters of effects that were not requested
/// are 0.
struct DistanceCounters {
  std::int64_t outer_iterations = 0;  ///< K of the paper: scalings of Q (1, except for `zheng_yamane`)
  std::int64_t ray_iterations =
      0;                    ///< N_rs of the paper: iterations of the ray shooter, all outer ones together
  std::int64_t pivots = 0;  ///< basis changes
  std::int64_t support_queries = 0;  ///< evaluations of h_A or h_Q over a whole set
  /// points whose reduced cost was computed, working sets included, or skipped by the tree of a prepared set
  std::int64_t points_priced = 0;
  std::int64_t refactorisations = 0;     ///< basis inverses computed afresh
  std::int64_t exact_pivots = 0;         ///< basis changes in exact arithmetic, where doubles did not suffice
  std::int64_t witness_evaluations = 0;  ///< contact points computed
  friend bool operator==(const DistanceCounters&, const DistanceCounters&) = default;
};

/// The answer to one distance query. Values that were not computed are NaN or empty.
struct DistanceResult {
  static constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

  double distance =
      kUnset;  ///< d_Q(A) of (5): within [lower, upper]; 0 for contains_origin, +inf for unreachable
  double lower = kUnset;  ///< certified: -h_A(u)/h_Q(-u) of (10), rounded down. After a proof in
                          ///< quadruple precision, `normal` is u rounded to doubles
  double upper = kUnset;  ///< certified: Σβ_j of a feasible combination, rounded up
  DistanceStatus status = DistanceStatus::precision_limit;
  double sigma = kUnset;    ///< `zheng_yamane`: the last σ_k of (8)
  double seconds = kUnset;  ///< wall time of the solve, where a time limit was set; otherwise unset

  /// Normal n_k of the hyperplane that separates A from d·Q, pointing to the side of d·Q, scaled so that
  /// h_Q(-normal) = 1. For `unreachable` it is the Farkas direction: h_A(normal) < 0 and h_Q(-normal) <= 0.
  /// Where Q touches the origin it may instead have h_A(normal) <= 0 and -normal·q < 0 for every point q of Q
  /// except the origin, which is then not in A.
  Vector normal;
  Vector contact_point;  ///< v of (15): a point of A ∩ dQ; only with Effects::witness

  /// `contains_origin` of a point set: what proves it. These points of A are affinely independent, and the
  /// one solution of Σ_i α_i a_i = 0, Σ_i α_i = 1 over them has α >= 0; the weights are that solution,
  /// rounded.
  std::vector<PointWeight> origin_weights;

  DistanceCounters counters;

  /// Room for a contact point of n doubles if it is asked for and `upper` proves that there is one; otherwise
  /// nullptr, and there is none.
  double* room_for_contact(Effects effects, int n) {
    const bool wanted = has_effect(effects, Effects::witness) && upper <= std::numeric_limits<double>::max();
    if (contact_point.size() != (wanted ? n : 0)) contact_point.resize(wanted ? n : 0);
    return wanted ? contact_point.data() : nullptr;
  }
};

/// The polytope that has proven a depth, as far as it is one of whatever pair is placed next: where its
/// corners are looked for, and how they are joined. Only solvers write it, as the proof needs a closed
/// surface.
class DepthMemory {
 public:
  /// A difference of two points: each is a vertex by its index, or the highest point, of a rim or of all. Its
  /// direction is fixed to the other body, which it mostly rests on.
  struct Corner {
    std::array<float, 3> way_1{}, way_2{};  ///< of the first body in the frame of the second, and vice versa
    std::int32_t index_1 = -1, index_2 = -1;
  };
  struct Facet {
    std::array<std::uint8_t, 3> corner{};
    std::array<std::uint16_t, 3> beyond{};
  };

  bool empty() const noexcept { return facets_.empty(); }
  const std::vector<Corner>& corners() const noexcept { return corners_; }
  const std::vector<Facet>& facets() const noexcept { return facets_; }

 private:
  template <class Real>
  friend class InnerPolytope;

  std::vector<Corner> corners_;
  std::vector<Facet> facets_;
  std::size_t least_corners_ = 0;  // of the polytope that was not made from this one
};

/// What one solve of a pair tells the next.
struct PairStart {
  /// Nothing is known of the pair.
  void clear() noexcept { dimension = 0; }

  int dimension = 0;                      ///< n of the solve that wrote it, 0 for none
  std::array<double, 3> normal{};         ///< its normal, for n <= 3 ...
  std::vector<double> long_normal;        ///< ... and for n > 3
  int count = 0;                          ///< support points of the last solve that are recorded below
  std::array<std::int32_t, 4> point_A{};  ///< their indices in A ...
  std::array<std::int32_t, 4> point_Q{};  ///< ... and in Q: of vertices, and of rims, in R^3
  bool overlap = false;                   ///< it has searched for a depth: the next solve does so first
};

/// Data kept from one solve of a pair to the next. The caller keeps one per pair and need not read it. It is
/// only a hint: an empty, old or wrong one costs time, and the answer is certified all the same.
struct WarmStart : PairStart {
  DepthMemory polytope;  ///< of the last depth
};

/// The normal that is recorded for R^n, if it can be one (n doubles, finite, not all zero); otherwise
/// nullptr.
const double* recorded_normal(const PairStart& warm, int n) noexcept;

/// Records `normal`, or that there is none.
void record_normal(const Vector& normal, PairStart& warm);

}  // namespace raygauge
