// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "raygauge/scene/motion.h"

namespace raygauge {

/// x ↦ R x + t in 3-space, of fixed size.
struct Frame {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
};

Frame make_frame(const Placement& where);

/// How far the points of a link within some distance of its origin may be from the chords of their paths: by
/// the number of joints, from the base on, that are left out, so that the link is seen from the link there.
struct ChordBounds {
  std::vector<double> curvature;  ///< |p''| at most
  std::vector<double> speed;      ///< |p'| at most

  /// Half-way of a time T, of which 4 s (1-s) is left at the share s.
  double sag(std::size_t left_out, double T) const noexcept;
};

/// All links of a robot while its joints move along a straight line: where they are, and how curved their
/// paths can be. Rounding errors as LinkMotion has them.
class RobotChain {
 public:
  /// Throws InvalidParameterError or NonFiniteError for a tree that is not one of `joints` joints.
  RobotChain(const KinematicTree& tree, int joints, const Placement& base);

  int joints() const noexcept { return static_cast<int>(first_.size()); }
  int links() const noexcept { return static_cast<int>(steps_.size()); }

  /// A fixed link. Throws InvalidParameterError if `parent` is none.
  int add_fixed_link(int parent, const Placement& origin);

  /// The line from q0 at `from` to q1 at `to` from now on.
  void follow(std::span<const double> q0, std::span<const double> q1, double from, double to);

  /// Every link at time t: links() frames.
  void place(double t, Frame* frames) const;

  /// Of link i at any time of the line.
  const PlacementError& error(int i) const noexcept { return errors_[static_cast<std::size_t>(i)]; }

  /// The bounds of link i for points within `reach` of its origin, into vectors that keep their memory.
  void bound(int i, double reach, ChordBounds& bounds) const;

  /// The links from the base to link i.
  const std::vector<int>& path(int i) const noexcept { return paths_[static_cast<std::size_t>(i)]; }

 private:
  struct Step {
    int parent = -1;
    Frame origin;
    JointKind kind = JointKind::fixed;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
    int joint = -1;
    double scale = 1, offset = 0;
    double length = 0;   // |origin.t|, and of a prismatic joint how far it shifts, over the line
    double rate = 0;     // of the joint
    double largest = 0;  // Σ |terms| of its value
  };

  void add(const TreeLink& link);
  void measure(std::size_t i);
  double value(const Step& step, double share) const;

  Frame base_;
  std::vector<Step> steps_;
  std::vector<std::vector<int>> paths_;
  std::vector<PlacementError> errors_;
  std::vector<double> ways_;  // from the scene's origin to that of a link, at most
  std::vector<double> first_, last_;
  double from_ = 0, to_ = 1;
};

}  // namespace raygauge
