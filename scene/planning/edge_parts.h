// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "scene/planning/edge_pair.h"
#include "scene/queries/part_solver.h"

namespace raygauge {

/// A part of each body of a pair, and what is kept of them from one edge to the next.
struct EdgeParts {
  int pair = 0;
  std::size_t shape_a = 0, shape_b = 0;
  bool is_mesh = false;  ///< one of them
  bool is_solid = false;
  PartMemory memory;
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();  ///< of the carrier; 0: none

  PartNumbers numbers() const { return {static_cast<int>(shape_a) - 1, static_cast<int>(shape_b) - 1}; }
};

/// The pairs of bodies that an edge is checked for, and their parts.
class EdgePairs {
 public:
  /// Throws InvalidParameterError where a pair to be left out names no body.
  EdgePairs(const RobotModel& robot, const RobotChain& chain, const std::vector<EdgeBody>& bodies);

  int size() const noexcept { return static_cast<int>(pairs_.size()); }
  const EdgePair& pair(int i) const { return pairs_[static_cast<std::size_t>(i)]; }
  const EdgePair& pair_of(const EdgeParts& parts) const { return pair(parts.pair); }

  /// All parts, those of one pair after those of the one before it.
  EdgeParts& parts(int number) { return parts_[static_cast<std::size_t>(number)]; }
  int first_parts(int pair) const { return first_parts_[static_cast<std::size_t>(pair)]; }

  void forget();

 private:
  void take_pairs(const RobotModel& robot, const RobotChain& chain, const std::vector<EdgeBody>& bodies);
  void take_parts(const std::vector<EdgeBody>& bodies);

  std::vector<EdgePair> pairs_;
  std::vector<int> first_parts_;  // of each pair; and the end
  std::vector<EdgeParts> parts_;
};

}  // namespace raygauge
