// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

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
                       std::shared_ptr<const JointTrajectory> trajectory, Placement base, int link, int above)
    : Motion(3, first_time(trajectory), trajectory->times.back()),
      tree_(std::move(tree)),
      trajectory_(std::move(trajectory)),
      base_(make_placement(base.R, base.t)) {
  if (tree_ == nullptr || link < 0 || link >= static_cast<int>(tree_->links.size())) {
    throw InvalidParameterError("joints: there is no link number " + std::to_string(link));
  }
  take_path(link, above);
  check();
  measure();
}

void LinkMotion::take_path(int link, int above) {
  for (int i = link; i >= 0 && i != above; i = tree_->links[static_cast<std::size_t>(i)].parent) {
    const TreeLink& step = tree_->links[static_cast<std::size_t>(i)];
    if (step.parent >= i) throw InvalidParameterError("joints: a link comes before its parent");
    numbers_.push_back(i);
    path_.push_back(step);
    path_.back().origin = make_placement(step.origin.R, step.origin.t);
  }
  std::reverse(numbers_.begin(), numbers_.end());
  std::reverse(path_.begin(), path_.end());
}

// How far the link's origin may be from each joint's, and what its placement loses: a frame loses 40 u in its
// rotation at every link, more where an angle is large, and its origin what the rotation before it turns the
// step by, and the rounding of the step and of the place that it is added to.
void LinkMotion::measure() {
  constexpr double kLinkRounding = 1e-14, kStepRounding = 1e-15;
  std::vector<double> steps;
  double way = base_.t.norm();
  for (TreeLink& link : path_) {
    link.axis.normalize();
    const double travel = link.kind == JointKind::fixed ? 0.0 : largest_value(link);
    steps.push_back(link.origin.t.norm() + (link.kind == JointKind::prismatic ? travel : 0.0));
    way += steps.back();
    error_.place += error_.turn * steps.back() + kStepRounding * (way + steps.back());
    error_.turn += kLinkRounding;
    if (link.kind == JointKind::prismatic) error_.place += kLinkRounding * travel;
    if (link.kind == JointKind::revolute) error_.turn += kStepRounding * travel;
  }
  reach_.assign(path_.size(), 0.0);
  for (std::size_t i = path_.size(); i-- > 1;) reach_[i - 1] = (reach_[i] + steps[i]) * kOutward;
}

MotionPointer LinkMotion::make(std::shared_ptr<const KinematicTree> tree,
                               std::shared_ptr<const JointTrajectory> trajectory, Placement base, int link,
                               int above) {
  auto motion =
      std::make_shared<LinkMotion>(std::move(tree), std::move(trajectory), std::move(base), link, above);
  if (motion->moves()) return motion;
  return std::make_shared<StaticMotion>(motion->at(motion->start()));
}

bool LinkMotion::moves() const {
  return std::any_of(path_.begin(), path_.end(), [this](const TreeLink& link) {
    if (link.kind == JointKind::fixed) return false;
    const auto values = trajectory_->values.row(link.joint);
    return values.minCoeff() != values.maxCoeff();
  });
}

int LinkMotion::common_link(const LinkMotion& one, const LinkMotion& other) {
  const bool one_robot = one.tree_ == other.tree_ && one.trajectory_ == other.trajectory_ &&
                         one.base_.R == other.base_.R && one.base_.t == other.base_.t;
  int common = -1;
  for (std::size_t i = 0; one_robot && i < std::min(one.numbers_.size(), other.numbers_.size()); ++i) {
    if (one.numbers_[i] != other.numbers_[i]) break;
    common = one.numbers_[i];
  }
  return common;
}

MotionPointer LinkMotion::seen_from(int above) const {
  return make(tree_, trajectory_, Placement::identity(3), numbers_.back(), above);
}

MotionPointer LinkMotion::of_link(int link) const { return make(tree_, trajectory_, base_, link); }

std::optional<SharedRide> shared_ride(const Motion& a, const Motion& b) {
  const auto* link_a = dynamic_cast<const LinkMotion*>(&a);
  const auto* link_b = dynamic_cast<const LinkMotion*>(&b);
  if (link_a == nullptr || link_b == nullptr) return std::nullopt;
  const int common = LinkMotion::common_link(*link_a, *link_b);
  if (common < 0) return std::nullopt;
  const MotionPointer carrier = link_a->of_link(common);
  if (carrier->is_static()) return std::nullopt;
  return SharedRide{carrier, link_a->seen_from(common), link_b->seen_from(common)};
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
  for (const TreeLink& link : path_) {
    if (link.kind == JointKind::fixed) continue;
    if (!(std::fabs(link.axis.norm() - 1) <= 1e-12))
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

// Σ |terms| of value() at any time.
double LinkMotion::largest_value(const TreeLink& link) const {
  return std::fabs(link.scale) * trajectory_->values.row(link.joint).cwiseAbs().maxCoeff() +
         std::fabs(link.offset);
}

double LinkMotion::rate(const TreeLink& link, std::size_t piece) const {
  if (link.kind == JointKind::fixed) return 0;
  const std::vector<double>& times = trajectory_->times;
  const auto column = static_cast<Eigen::Index>(piece);
  if (trajectory_->values(link.joint, column + 1) == trajectory_->values(link.joint, column)) return 0;
  return link.scale *
         (trajectory_->values(link.joint, column + 1) - trajectory_->values(link.joint, column)) /
         (times[piece + 1] - times[piece]);
}

LinkMotion::Chain LinkMotion::chain_at(double t) const {
  Chain chain;
  Placement here = base_;
  for (const TreeLink& link : path_) {
    here = here * link.origin;
    chain.axes.emplace_back(here.R * link.axis);
    if (link.kind == JointKind::revolute) here.R = here.R * rotation_about(value(link, t) * link.axis);
    if (link.kind == JointKind::prismatic) here.t += here.R * (value(link, t) * link.axis);
    chain.frames.push_back(here);
  }
  return chain;
}

std::vector<Twist> LinkMotion::joint_twists(double t) const {
  std::vector<Twist> twists(static_cast<std::size_t>(trajectory_->values.rows()));
  const Chain chain = chain_at(t);
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const TreeLink& link = path_[i];
    if (link.kind == JointKind::fixed) continue;
    Twist& twist = twists[static_cast<std::size_t>(link.joint)];
    const Eigen::Vector3d a = link.scale * chain.axes[i], arm = chain.frames.back().t - chain.frames[i].t;
    const Vector3 axis{a[0], a[1], a[2]};
    if (link.kind == JointKind::prismatic) {
      twist.linear = twist.linear + axis;
    } else {
      twist.linear = twist.linear + cross(axis, Vector3{arm[0], arm[1], arm[2]});
      twist.angular = twist.angular + axis;
    }
  }
  return twists;
}

Placement LinkMotion::do_at(double t) const {
  if (path_.empty()) return base_;
  return chain_at(t).frames.back();
}

// Over any interval the link's origin moves no faster than Σ |q̇_i| reach_i (revolute) and |q̇_i| (prismatic).
double LinkMotion::fastest(std::size_t piece) const {
  double sum = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    sum += std::fabs(rate(path_[i], piece)) * (path_[i].kind == JointKind::revolute ? reach_[i] : 1.0);
  }
  return sum;
}

// Two bounds, of which the better is taken: the one of fastest(), and, over a short interval, the velocity of
// the middle but for how far axes and levers can turn from there: joint i's axis by Ω_i h, Ω_i the joints'
// speeds before it, and a lever by the speeds of its ends. What the chain of the middle loses is in its
// axes and levers.
MotionBound LinkMotion::do_bound(double from, double to) const {
  if (path_.empty()) return {SmallVector::Zero(3)};
  const std::size_t piece = piece_of(from);
  const double half = (to - from) / 2;
  const Chain chain = chain_at(from + half);
  const Eigen::Vector3d end = chain.frames.back().t;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), spin = velocity;
  const double fastest_origin = fastest(piece);
  double turning = 0;  // Ω_i
  double velocity_error = 0, spin_error = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const double q = rate(path_[i], piece);
    const double speed = std::fabs(q);
    const double axis_error = std::min(2.0, turning * half) + error_.turn;
    if (path_[i].kind == JointKind::revolute) {
      velocity += q * chain.axes[i].cross(end - chain.frames[i].t);
      spin += q * chain.axes[i];
      velocity_error += speed * (axis_error * reach_[i] + std::min(2 * reach_[i], 2 * fastest_origin * half) +
                                 2 * error_.place);
      spin_error += speed * axis_error;
      turning += speed;
    } else if (path_[i].kind == JointKind::prismatic) {
      velocity += q * chain.axes[i];
      velocity_error += speed * axis_error;
    }
  }
  const double rounding = 1e-13 * (fastest_origin + turning);
  spin_error = spin_error * kOutward + rounding;
  if (velocity.norm() + velocity_error <= fastest_origin) {
    return {velocity, velocity_error * kOutward + rounding, spin, spin_error};
  }
  return {SmallVector::Zero(3), fastest_origin * kOutward + rounding, spin, spin_error};
}

double LinkMotion::do_next_break(double t) const {
  const std::vector<double>& times = trajectory_->times;
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  return next == times.end() ? std::numeric_limits<double>::infinity() : *next;
}

}  // namespace raygauge
