// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The polytope that has proven a depth, as far as it is one of whatever pair is placed next: where its
/// corners are looked for, and how they are joined. Only solvers write it, as the proof needs a closed
/// surface.
class DepthMemory {
 public:
  /// Of a difference of points, one of each body: a vertex or a rim by its index, and ...
  struct Corner {
    std::array<float, 3> way_1{}, way_2{};  ///< ... the way from a rim's centre, or the direction
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
  std::array<std::int32_t, 4> point_Q{};  ///< ... and in Q, for prepared sets of R^3
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
