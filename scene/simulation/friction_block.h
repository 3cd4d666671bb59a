// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include "scene/simulation/friction_newton.h"

namespace raygauge {

/// The contacts of some bodies of an island, solved together while all other impulses stay. Where friction
/// turns with every impulse of a neighbour, contacts one by one come round and round to where they were.
class FrictionBlock {
 public:
  FrictionBlock(const FrictionIsland& island, std::set<int> bodies);

  const std::set<int>& bodies() const { return bodies_; }
  std::size_t size() const { return contacts_.size(); }
  bool has(std::size_t contact) const;

  /// By Newton's method from r, or by softer contacts. `velocities`: those of r.
  void solve(const FrictionIsland& island, IslandVelocities& velocities, Eigen::VectorXd& r);

 private:
  std::set<int> bodies_;
  std::vector<std::size_t> contacts_;  // in rising order
  FrictionIsland own_;                 // of them alone; of no velocities but those of the last solve()
  IslandNewton newton_;
  bool is_new_ = true;
  int paths_ = 2;      // that may still be followed
  bool lost_ = false;  // it could not be solved: its contacts are left to passes, until it grows
};

}  // namespace raygauge
