// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "scene/simulation/lanes.h"

namespace raygauge {

/// Anderson's extrapolation (1965) of r -> g(r): of what was seen last, the combination whose changes g - r
/// cancel best.
class Extrapolation {
 public:
  explicit Extrapolation(Eigen::Index size);

  void forget() { count_ = 0; }

  /// Where to go on after r with the change f = g - r and the value g.
  void next(const Eigen::VectorXd& f, const Eigen::VectorXd& g, Eigen::VectorXd& here);

 private:
  static constexpr int kMemory = 8;  // values; as many as lanes
  using Few = std::array<double, kMemory>;

  struct Row {
    Eight of = {};
  };

  void learn(int at, const Eigen::VectorXd& f);
  Few shares(int known) const;

  int count_ = 0;
  std::vector<Row> changes_;  // of each number of f, the last ones
  Eigen::MatrixXd values_;    // those of g, one a column
  Eight products_[kMemory] = {};
  Eight by_f_ = {};
  Eigen::VectorXd f_, g_;
};

}  // namespace raygauge
