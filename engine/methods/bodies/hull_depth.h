// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/methods/bodies/depth_search.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/numerics/dense.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The depth  min h_D(u)/h_Q(u)  of D = A2 - A1 in a metric Q, all of one space R^4 to R^6, by their support
/// mappings in doubles: what DepthSearch does in R^3, with an InnerHull. The least offset/h_Q(n) over the
/// facets of a polytope inside D is a lower bound for all directions at once; the facet that is least is
/// expanded until an upper bound meets it.
class HullDepth {
 public:
  static constexpr int kLeast = 4, kMost = 6;  ///< dimensions

  HullDepth();
  ~HullDepth();
  HullDepth(HullDepth&&) noexcept;
  HullDepth& operator=(HullDepth&&) noexcept;

  /// `start`: a direction near the normal, or nullptr. Ends when the gap is `tolerance` times the upper
  /// bound.
  DepthEnd run(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
               const double* start, const Stopwatch& watch);

  double lower() const noexcept;  ///< 0 where nothing is proven
  double upper() const noexcept;
  int iterations() const noexcept;
  std::int64_t queries() const noexcept;  ///< of the support mappings

  /// The direction that proves upper(), with h_Q = 1 in about; empty if there is none.
  void put_normal(Vector& u) const;

  /// The points of both sets whose difference is t q, where the ray along the support point q of Q for the
  /// normal leaves the polytope: t is between both bounds. Empty where the origin is not inside.
  void put_points(Vector& a1, Vector& a2) const;

 private:
  class Search;
  template <int N>
  class SearchIn;
  std::array<std::unique_ptr<Search>, kMost - kLeast + 1> search_;  // by dimension, made when first asked
  Search* used_ = nullptr;
};

}  // namespace raygauge
