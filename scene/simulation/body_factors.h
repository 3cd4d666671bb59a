// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>
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

  /// Adds to the block of two bodies that share a contact, or of one.
  void add(int i, int j, const Block& block);

  /// Then only solve() may be asked, until set_identity().
  void factorize();

  /// In place.
  void solve(Columns& x) const;

 private:
  struct Pivot {
    int body = 0;
    std::vector<int> later;  // pivots that it is joined to, in rising order
    Block diagonal;
    Eigen::PartialPivLU<Block> factors;  // of it, without those before
    std::vector<Block> below, right;     // the latter, factorized, times its inverse

    template <class Column>
    void divide(Column&& column) const {
      column = Eigen::Matrix<double, 6, 1>(factors.solve(Eigen::Matrix<double, 6, 1>(column)));
    }
  };

  Block& at(int row, int column);

  std::vector<Pivot> pivots_;
  std::vector<int> pivot_of_;  // each body
};

}  // namespace raygauge
