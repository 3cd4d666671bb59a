// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/joint_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-13;

double first_time(const std::shared_ptr<const JointTrajectory>& trajectory) {
  if (trajectory == nullptr || trajectory->times.size() < 2) {
    throw InvalidParameterError("joints: a trajectory needs two times at least");
  }
  return trajectory->times.front();
}

}  // namespace

LinkMotion::LinkMotion(std::shared_ptr<const KinematicTree> tree,
                       std::shared_ptr<const JointTrajectory> trajectory, Placement base, int link)
    : Motion(3, first_time(trajectory), trajectory->times.back()),
      tree_(std::move(tree)),
      trajectory_(std::move(trajectory)),
      base_(std::move(base)) {
  if (tree_ == nullptr || link < 0 || link >= static_cast<int>(tree_->links.size())) {
    throw InvalidParameterError("joints: there is no link number " + std::to_string(link));
  }
  for (int i = link; i >= 0; i = tree_->links[static_cast<std::size_t>(i)].parent) path_.push_back(i);
  std::reverse(path_.begin(), path_.end());
  check();
  // From joint i on, the way to the link's origin is at most the sum of the steps between joints.
  reach_.assign(path_.size(), 0.0);
  for (std::size_t i = path_.size() - 1; i-- > 0;) {
    const TreeLink& next = tree_->links[static_cast<std::size_t>(path_[i + 1])];
    double step = next.origin.t.norm();
    if (next.kind == JointKind::prismatic) {
      double travel = 0;
      for (const double t : trajectory_->times) travel = std::max(travel, std::fabs(value(next, t)));
      step += travel;
    }
    reach_[i] = (reach_[i + 1] + step) * kOutward;
  }
}

void LinkMotion::check() const {
  const JointTrajectory& trajectory = *trajectory_;
  if (trajectory.values.cols() != static_cast<Eigen::Index>(trajectory.times.size())) {
    throw InvalidParameterError("joints: every time of a trajectory needs its values");
  }
  if (!trajectory.values.allFinite()) throw NonFiniteError("joints: a value is not finite");
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    if (!std::isfinite(trajectory.times[k])) throw NonFiniteError("joints: a time is not finite");
    if (k > 0 && !(trajectory.times[k - 1] < trajectory.times[k])) {
      throw InvalidParameterError("joints: times must rise, but " + std::to_string(trajectory.times[k]) +
                                  " comes after " + std::to_string(trajectory.times[k - 1]));
    }
  }
  for (const int i : path_) {
    const TreeLink& link = tree_->links[static_cast<std::size_t>(i)];
    if (link.parent >= i) throw InvalidParameterError("joints: a link comes before its parent");
    if (link.kind == JointKind::fixed) continue;
    if (std::fabs(link.axis.norm() - 1) > 1e-12)
      throw InvalidParameterError("joints: an axis is not of length 1");
    if (link.joint < 0 || link.joint >= trajectory.values.rows()) {
      throw InvalidParameterError("joints: a joint has no values");
    }
  }
}

std::size_t LinkMotion::piece_of(double t) const {
  const std::vector<double>& times = trajectory_->times;
  return static_cast<std::size_t>(std::upper_bound(times.begin() + 1, times.end() - 1, t) - times.begin()) -
         1;
}

double LinkMotion::value(const TreeLink& link, double t) const {
  const std::vector<double>& times = trajectory_->times;
  const std::size_t i = piece_of(t);
  const auto column = static_cast<Eigen::Index>(i);
  const double s = (t - times[i]) / (times[i + 1] - times[i]);
  const double q =
      (1 - s) * trajectory_->values(link.joint, column) + s * trajectory_->values(link.joint, column + 1);
  return link.scale * q + link.offset;
}

double LinkMotion::rate(const TreeLink& link, std::size_t piece) const {
  if (link.kind == JointKind::fixed) return 0;
  const std::vector<double>& times = trajectory_->times;
  const auto column = static_cast<Eigen::Index>(piece);
  return link.scale *
         (trajectory_->values(link.joint, column + 1) - trajectory_->values(link.joint, column)) /
         (times[piece + 1] - times[piece]);
}

LinkMotion::Chain LinkMotion::chain_at(double t) const {
  Chain chain;
  Placement here = base_;
  for (const int i : path_) {
    const TreeLink& link = tree_->links[static_cast<std::size_t>(i)];
    here = here * link.origin;
    chain.axes.emplace_back(here.R * link.axis);
    if (link.kind == JointKind::revolute) here.R = here.R * rotation_about(value(link, t) * link.axis);
    if (link.kind == JointKind::prismatic) here.t += here.R * (value(link, t) * link.axis);
    chain.frames.push_back(here);
  }
  return chain;
}

Placement LinkMotion::do_at(double t) const { return chain_at(t).frames.back(); }

// Two bounds, of which the better is taken. Over any interval the link's origin moves no faster than Σ |q̇_i|
// reach_i (revolute) and |q̇_i| (prismatic). Over a short one its velocity is that of the middle but for how
// far axes and levers can turn from there: joint i's axis by Ω_i h, Ω_i the joints' speeds before it, and a
// lever by the speeds of its ends.
MotionBound LinkMotion::do_bound(double from, double to) const {
  const std::size_t piece = piece_of(from);
  const double half = (to - from) / 2;
  const Chain chain = chain_at(from + half);
  const Eigen::Vector3d end = chain.frames.back().t;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  double fastest = 0;  // of the origin
  double turning = 0;  // Ω_i
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const TreeLink& link = tree_->links[static_cast<std::size_t>(path_[i])];
    const double speed = std::fabs(rate(link, piece));
    fastest += speed * (link.kind == JointKind::revolute ? reach_[i] : 1.0);
  }
  double velocity_error = 0;
  double spin_error = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const TreeLink& link = tree_->links[static_cast<std::size_t>(path_[i])];
    const double q = rate(link, piece);
    const double speed = std::fabs(q);
    const double axis_error = std::min(2.0, turning * half);
    if (link.kind == JointKind::revolute) {
      const Eigen::Vector3d joint_origin = chain.frames[i].t;
      velocity += q * chain.axes[i].cross(end - joint_origin);
      spin += q * chain.axes[i];
      velocity_error += speed * (axis_error * reach_[i] + std::min(2 * reach_[i], 2 * fastest * half));
      spin_error += speed * axis_error;
      turning += speed;
    } else if (link.kind == JointKind::prismatic) {
      velocity += q * chain.axes[i];
      velocity_error += speed * axis_error;
    }
  }
  const double rounding = 1e-13 * (fastest + turning);
  if (velocity.norm() + velocity_error <= fastest) {
    return {velocity, velocity_error * kOutward + rounding, spin, spin_error * kOutward + rounding};
  }
  return {SmallVector::Zero(3), fastest * kOutward + rounding, spin, spin_error * kOutward + rounding};
}

double LinkMotion::do_next_break(double t) const {
  const std::vector<double>& times = trajectory_->times;
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  return next == times.end() ? std::numeric_limits<double>::infinity() : *next;
}

}  // namespace raygauge
