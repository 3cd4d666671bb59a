// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/robot_chain.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

// What a few sums and products of bounds may lose, with room to spare.
constexpr double kOutward = 1 + 1e-12;

// As of LinkMotion: what a rotation loses at a link, and what a step or an angle loses of itself.
constexpr double kLinkRounding = 1e-14, kStepRounding = 1e-15;

// Rotation by `angle` about a unit vector.
Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const Eigen::Vector3d sa = s * axis, ca = (1 - c) * axis;
  Eigen::Matrix3d R = ca * axis.transpose();
  R(0, 0) += c;
  R(1, 1) += c;
  R(2, 2) += c;
  R(1, 0) += sa[2];
  R(0, 1) -= sa[2];
  R(0, 2) += sa[1];
  R(2, 0) -= sa[1];
  R(2, 1) += sa[0];
  R(1, 2) -= sa[0];
  return R;
}

}  // namespace

Frame make_frame(const Placement& where) {
  return {Eigen::Matrix3d::Map(where.R.data()), Eigen::Vector3d::Map(where.t.data())};
}

double ChordBounds::sag(std::size_t left_out, double T) const noexcept {
  return std::min(curvature[left_out] * T / 8, speed[left_out] / 2) * T * kOutward;
}

RobotChain::RobotChain(const KinematicTree& tree, int joints, const Placement& base) {
  if (joints < 0) throw InvalidParameterError("robot: there cannot be less than no joints");
  const auto count = static_cast<std::size_t>(joints);
  first_.assign(count, 0.0);
  last_.assign(count, 0.0);
  const Placement at = make_placement(base.R, base.t);
  if (at.dimension() != 3) throw DimensionMismatchError("robot: its base is not a placement of R^3");
  base_ = make_frame(at);
  for (const TreeLink& link : tree.links) add(link);
}

void RobotChain::add(const TreeLink& link) {
  const auto i = static_cast<int>(steps_.size());
  if (link.parent >= i || link.parent < -1) {
    throw InvalidParameterError("robot: a link comes before its parent");
  }
  if (link.kind != JointKind::fixed && (link.joint < 0 || link.joint >= joints())) {
    throw InvalidParameterError("robot: there is no joint number " + std::to_string(link.joint));
  }
  if (!std::isfinite(link.scale) || !std::isfinite(link.offset) || !link.axis.allFinite()) {
    throw NonFiniteError("robot: a number of a joint is not finite");
  }
  if (link.kind != JointKind::fixed && !(std::fabs(link.axis.norm() - 1) <= 1e-12)) {
    throw InvalidParameterError("robot: an axis is not of length 1");
  }
  const Placement origin = make_placement(link.origin.R, link.origin.t);
  if (origin.dimension() != 3) throw DimensionMismatchError("robot: an origin is not a placement of R^3");
  Step step;
  step.parent = link.parent;
  step.origin = make_frame(origin);
  step.kind = link.kind;
  step.axis = link.axis.normalized();
  step.joint = link.joint;
  step.scale = link.scale;
  step.offset = link.offset;
  steps_.push_back(step);
  paths_.push_back(link.parent < 0 ? std::vector<int>() : path(link.parent));
  paths_.back().push_back(i);
  errors_.emplace_back();
  ways_.push_back(0);
}

int RobotChain::add_fixed_link(int parent, const Placement& origin) {
  if (parent < 0 || parent >= links()) {
    throw InvalidParameterError("robot: there is no link number " + std::to_string(parent));
  }
  TreeLink link;
  link.parent = parent;
  link.origin = origin;
  add(link);
  return links() - 1;
}

void RobotChain::follow(std::span<const double> q0, std::span<const double> q1, double from, double to) {
  std::copy(q0.begin(), q0.end(), first_.begin());
  std::copy(q1.begin(), q1.end(), last_.begin());
  from_ = from;
  to_ = to;
  for (std::size_t i = 0; i < steps_.size(); ++i) measure(i);
}

// As LinkMotion::measure() does, over this line.
void RobotChain::measure(std::size_t i) {
  Step& step = steps_[i];
  step.length = step.origin.t.norm();
  step.rate = step.largest = 0;
  if (step.kind != JointKind::fixed) {
    const double q0 = first_[static_cast<std::size_t>(step.joint)];
    const double q1 = last_[static_cast<std::size_t>(step.joint)];
    step.largest = std::fabs(step.scale) * std::max(std::fabs(q0), std::fabs(q1)) + std::fabs(step.offset);
    if (q0 != q1) step.rate = std::fabs(step.scale * (q1 - q0) / (to_ - from_));
    if (step.kind == JointKind::prismatic) step.length += step.largest;
  }
  const bool root = step.parent < 0;
  const auto parent = static_cast<std::size_t>(std::max(step.parent, 0));
  PlacementError error = root ? PlacementError{} : errors_[parent];
  ways_[i] = (root ? base_.t.norm() : ways_[parent]) + step.length;
  error.place += error.turn * step.length + kStepRounding * (ways_[i] + step.length);
  error.turn += kLinkRounding;
  if (step.kind == JointKind::prismatic) error.place += kLinkRounding * step.largest;
  if (step.kind == JointKind::revolute) error.turn += kStepRounding * step.largest;
  errors_[i] = error;
}

double RobotChain::value(const Step& step, double share) const {
  const auto joint = static_cast<std::size_t>(step.joint);
  return step.scale * ((1 - share) * first_[joint] + share * last_[joint]) + step.offset;
}

void RobotChain::place(double t, Frame* frames) const {
  const double share = (t - from_) / (to_ - from_);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const Frame& parent = step.parent < 0 ? base_ : frames[step.parent];
    Frame& here = frames[i];
    here.t = parent.t + parent.R * step.origin.t;
    here.R.noalias() = parent.R * step.origin.R;
    if (step.kind == JointKind::revolute) here.R = here.R * turn_about(step.axis, value(step, share));
    if (step.kind == JointKind::prismatic) here.t += here.R * (value(step, share) * step.axis);
  }
}

// From the link on back to the base: with ρ the distance that joint d has from the points, at most, and V the
// sum of the joints after it, |∂²p/∂q_d∂q_j| <= ρ_j for every revolute d before j, and d = j.
void RobotChain::bound(int i, double reach, ChordBounds& bounds) const {
  const std::vector<int>& way = path(i);
  bounds.curvature.assign(way.size() + 1, 0.0);
  bounds.speed.assign(way.size() + 1, 0.0);
  double C = 0, V = 0, rho = reach;
  for (std::size_t d = way.size(); d-- > 0;) {
    const Step& step = steps_[static_cast<std::size_t>(way[d])];
    if (step.kind == JointKind::revolute) {
      C += step.rate * (step.rate * rho + 2 * V);
      V += step.rate * rho;
    } else if (step.kind == JointKind::prismatic) {
      V += step.rate;
    }
    bounds.curvature[d] = C;
    bounds.speed[d] = V;
    rho = (rho + step.length) * kOutward;
  }
}

}  // namespace raygauge
