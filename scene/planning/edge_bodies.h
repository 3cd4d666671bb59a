// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "scene/planning/robot_chain.h"

namespace raygauge {

class PlacedPair;

/// One convex part of a body, or all of it, as tests over a time see it; in the frame of the body.
struct EdgeShape {
  const BodyPart* part = nullptr;  ///< null: the whole body
  Eigen::Vector3d center;          ///< of a ball that holds it
  double radius = 0;
  double center_reach = 0, reach = 0, core_reach = 0;  ///< from the origin of the body, at most
  Eigen::Vector3d low, high;  ///< of a box that holds it, where the body stands still
  double thickness = 0;       ///< half the least side of that box

  ChordBounds of_center, of_points;  ///< of a robot's, over the edge in which they were made
  std::int64_t edge = 0;
};

/// A body of the robot, or an obstacle.
struct EdgeBody {
  Body body;
  int link = -1;                           ///< -1: an obstacle
  bool stands = true;                      ///< of an obstacle
  Frame at;                                ///< where it stands
  int moving = -1;                         ///< its number among the obstacles that move
  std::vector<EdgeShape> shapes;           ///< the whole body, then its parts, then nodes of its tree
  std::vector<std::size_t> shape_of_node;  ///< of that tree; empty: there is none

  bool is_obstacle() const noexcept { return link < 0; }

  /// Of node i, as part_node() has it.
  std::size_t shape_of(int i) const {
    if (!shape_of_node.empty()) return shape_of_node[static_cast<std::size_t>(i)];
    return body.parts.size() == 1 ? 1 : static_cast<std::size_t>(i);
  }
};

/// The bodies of a robot, then the obstacles; a grasped body hangs on a link of its own, which `chain` gets.
/// Throws what EdgeChecker throws.
std::vector<EdgeBody> edge_bodies(const RobotModel& robot, const std::vector<Body>& obstacles,
                                  RobotChain& chain);

/// Where all bodies are at the moments that an edge is looked at, each computed once.
class EdgeStage {
 public:
  EdgeStage(const RobotChain& chain, const std::vector<EdgeBody>& bodies);

  /// No moments.
  void clear() noexcept { times_.clear(); }

  /// A moment; its number.
  int add(double t);
  double time(int moment) const { return times_[static_cast<std::size_t>(moment)]; }

  const Frame& link(int moment, int link) const {
    return links_[static_cast<std::size_t>(moment * chain_.links() + link)];
  }
  const Frame& at(int moment, const EdgeBody& body) const;

  /// Two bodies where they are at a moment, for the solvers of Euclidean distances.
  void place(int moment, const EdgeBody& a, const EdgeBody& b, PlacedPair& placed) const;

  /// How far placements are from those of the exact motion, at most.
  const PlacementError& error(int moment, const EdgeBody& body) const;

 private:
  const RobotChain& chain_;
  std::vector<const EdgeBody*> moving_;
  std::vector<double> times_;
  std::vector<Frame> links_, obstacles_;
  std::vector<PlacementError> errors_;  // of obstacles_
};

}  // namespace raygauge
