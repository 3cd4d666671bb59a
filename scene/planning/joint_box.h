// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/planning/edge_bodies.h"

namespace raygauge {

/// A box of joint values that is not proven.
struct JointBox {
  double key = 0;              ///< the least is looked at first
  double share = 1;            ///< of the volume of all
  int widest = -1;             ///< the joint along which to halve it
  std::vector<double> middle;  ///< of the joints between the bodies
  std::vector<double> half;
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();  ///< that set two parts apart in its middle; 0: none
  int parts = 0;                                    ///< which
};

/// The joints between two bodies of a robot, in the order from the one to the other, and how far the bodies
/// move against each other while these change.
class JointsBetween {
 public:
  /// `tree` is that of the robot on which both bodies hang.
  JointsBetween(const KinematicTree& tree, const RobotChain& chain, int link_a, int link_b);

  /// The joints that take a value, by their numbers, each once.
  const std::vector<int>& joints() const noexcept { return joints_; }

  /// Whether one of them turns.
  bool turns() const noexcept;

  /// The link that turns with the one joint between the two, and the axis in its frame; -1: there are more,
  /// or it is shifted.
  int only_turning_link() const noexcept { return steps_.size() == 1 && turns() ? steps_[0].link : -1; }
  const Eigen::Vector3d& only_axis() const { return steps_.at(0).axis; }

  /// From now on the robot stands so.
  void stand(const Frame* links, const EdgeBody& a, const EdgeBody& b);

  /// With every joint k changed by at most half[k], points of both bodies move by at most this, together,
  /// as seen from the link between them that makes it least.
  double motion(const std::vector<double>& half);

  /// The joint whose change has most part in the last motion(); -1: none has any.
  int widest() const noexcept { return widest_; }

 private:
  struct Step {
    int link = 0, joint = 0;
    bool turns = true;
    double scale = 1;
    Eigen::Vector3d axis;
    double lever_a = 0, lever_b = 0;  ///< distances of points of a and of b from the axis, at most
    double change = 0;
  };

  double moved(const Step& step, double lever, double before) const;

  std::vector<Step> steps_;
  std::vector<int> joints_;
  std::vector<double> of_a_, of_b_, parts_;
  int widest_ = -1;
};

}  // namespace raygauge
