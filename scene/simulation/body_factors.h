// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "scene/simulation/friction_island.h"

namespace raygauge {

/// A matrix of blocks of 6 × 6, one for each two bodies of an island that share a contact, and its factors L
/// U, the bodies of fewest neighbours first.
class BodyFactors {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;
  using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic>;  ///< six numbers of each body

  explicit BodyFactors(const FrictionIsland& island);

  void set_identity();

  /// Where the block of two bodies is that share a contact, or of one.
  std::size_t place_of(int i, int j) const;

  /// Adds to the block there.
  template <class Sum>
  void add(std::size_t place, const Sum& block) {
    blocks_[place] += block;
  }

  /// Then only solve() may be asked, until set_identity().
  void factorize();

  /// In place.
  void solve(Columns& x) const;

 private:
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

  std::vector<Pivot> pivots_;
  std::vector<int> pivot_of_;  // each body
  std::vector<Block> blocks_;
  std::vector<std::size_t> changed_;  // places that the pivots change, in turn
};

}  // namespace raygauge
