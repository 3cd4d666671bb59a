// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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
    std::array<std::uint8_t, 3> corner{}, neighbour{};
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

}  // namespace raygauge
