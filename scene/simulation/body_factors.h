// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "scene/simulation/friction_island.h"
#include "scene/simulation/lanes.h"

namespace raygauge {

/// A matrix of blocks of 6 × 6, one for each two bodies of an island that share a contact, and its factors L
/// U, the bodies of fewest neighbours first. The same bits whatever the machine.
class BodyFactors {
 public:
  explicit BodyFactors(const FrictionIsland& island);

  void set_identity();

  /// Where the blocks aa, ab, ba, bb of the bodies of a contact are.
  using Places = std::array<std::size_t, 4>;
  Places places_of(const IslandContact& contact) const;

  /// Adds G M Hᵀ for each two of the slopes G, H of a contact, in the blocks of their bodies.
  void add(const IslandContact& contact, const Places& places, const Eigen::Matrix3d& M);

  /// Then only solve() may be asked, until set_identity().
  void factorize();

  /// In place.
  void solve(BodyColumns& x);

 private:
  struct Block {
    Eight column[6] = {};
  };

  // Its blocks: the diagonal one, which becomes its inverse without those before it; those below, ...
  // ... which become such times the inverse; those on the right.
  struct Pivot {
    int body = 0;
    std::vector<int> later;  // pivots that it is joined to, in rising order
    std::size_t first = 0;   // place of its blocks

    std::size_t below(std::size_t k) const { return first + 1 + k; }
    std::size_t right(std::size_t k) const { return first + 1 + later.size() + k; }
  };

  std::size_t place_of_pivots(int row, int column) const;
  static void invert(Block& A);
  static Eight product(const Block& A, const Eight& x);
  void solve_lanes();

  std::vector<Pivot> pivots_;
  std::vector<int> pivot_of_;  // each body
  std::vector<Block> blocks_;
  std::vector<std::size_t> changed_;  // places that the pivots change, in turn
  std::vector<BodyLanes> x_;          // of solve(), in the order of the pivots
};

}  // namespace raygauge
