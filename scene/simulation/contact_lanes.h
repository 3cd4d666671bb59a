// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "scene/simulation/friction_island.h"
#include "scene/simulation/lanes.h"

namespace raygauge {

/// A contact of an island as passes read it: rows and columns filled up with zeros.
struct ContactLanes {
  struct Side {
    std::size_t body = 0;
    Four row[6] = {};      ///< of A
    Eight column[3] = {};  ///< of A
  };

  Side a, b;
  Four q = {};
  Four W[3] = {}, inverse[3] = {};  ///< columns of A_aᵀ A_a + A_bᵀ A_b, and of its inverse
  std::size_t at = 0;               ///< of its impulse among all
  double mu = 0;
  double rate = 0;  ///< 1 / the mean of W across the normal
};

/// The contacts of an island, and the scaled velocities of its bodies that impulses r give. The same bits
/// whatever the machine.
class IslandLanes {
 public:
  explicit IslandLanes(const FrictionIsland& island);

  /// One pass of Gauss and Seidel's method from r on. Leaves the velocities of the new r.
  void pass(Eigen::VectorXd& r);

  /// Σ law_error(), where the velocities of r are known; s = 1/‖W‖.
  double error(double s, const Eigen::VectorXd& r) const;

  /// Velocities of r.
  void reset(const Eigen::VectorXd& r);

 private:
  std::vector<ContactLanes> contacts_;
  std::vector<BodyLanes> bodies_;  // the last one stands for all that do not react
};

}  // namespace raygauge
