// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/joint_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

// What sums and products of bounds lose, and places, with room to spare.
constexpr double kOutward = 1 + 1e-12, kPlace = 1e-13;

/// The greatest distance of points of a body from a line, by its ball and by its box.
double lever_of(const EdgeBody& body, const Frame& at, const Frame& line, const Eigen::Vector3d& axis) {
  const EdgeShape& whole = body.shapes.front();
  const auto distance = [&](const Eigen::Vector3d& p) {
    return (at.R * p + at.t - line.t).cross(axis).norm();
  };
  const double by_ball = distance(whole.center) + whole.radius;
  double by_box = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1) != 0 ? whole.high[k] : whole.low[k];
    by_box = std::max(by_box, distance(p));
  }
  const double size = 1 + at.t.norm() + line.t.norm() + body.body.reach;
  return std::min(by_ball, by_box) * kOutward + kPlace * size;
}

}  // namespace

JointsBetween::JointsBetween(const KinematicTree& tree, const RobotChain& chain, int link_a, int link_b) {
  const std::vector<int>&one = chain.path(link_a), &two = chain.path(link_b);
  std::size_t common = 0;
  while (common < std::min(one.size(), two.size()) && one[common] == two[common]) ++common;
  std::vector<int> way(one.rbegin(), one.rend() - static_cast<std::ptrdiff_t>(common));
  way.insert(way.end(), two.begin() + static_cast<std::ptrdiff_t>(common), two.end());
  for (const int link : way) {
    if (link >= static_cast<int>(tree.links.size())) continue;  // on which a body hangs, fixed
    const TreeLink& of = tree.links[static_cast<std::size_t>(link)];
    if (of.kind == JointKind::fixed || of.scale == 0) continue;
    Step step;
    step.link = link;
    step.joint = of.joint;
    step.turns = of.kind == JointKind::revolute;
    step.scale = std::fabs(of.scale);
    step.axis = of.axis.normalized();
    steps_.push_back(step);
    if (std::find(joints_.begin(), joints_.end(), of.joint) == joints_.end()) joints_.push_back(of.joint);
  }
}

bool JointsBetween::turns() const noexcept {
  return std::any_of(steps_.begin(), steps_.end(), [](const Step& step) { return step.turns; });
}

void JointsBetween::stand(const Frame* links, const EdgeBody& a, const EdgeBody& b) {
  for (Step& step : steps_) {
    if (!step.turns) continue;
    const Frame& line = links[step.link];
    const Eigen::Vector3d axis = line.R * step.axis;
    step.lever_a = lever_of(a, links[a.link], line, axis);
    step.lever_b = lever_of(b, links[b.link], line, axis);
  }
}

double JointsBetween::moved(const Step& step, double lever, double before) const {
  if (!step.turns) return before + step.change;
  return before + 2 * std::sin(std::min<double>(step.change, EIGEN_PI) / 2) * (lever + before);
}

double JointsBetween::motion(const std::vector<double>& half) {
  const std::size_t count = steps_.size();
  of_a_.assign(count + 1, 0.0);
  of_b_.assign(count + 1, 0.0);
  for (Step& step : steps_) step.change = step.scale * half[static_cast<std::size_t>(step.joint)];
  for (std::size_t s = 0; s < count; ++s) of_a_[s + 1] = moved(steps_[s], steps_[s].lever_a, of_a_[s]);
  for (std::size_t s = count; s-- > 0;) of_b_[s] = moved(steps_[s], steps_[s].lever_b, of_b_[s + 1]);
  std::size_t from = 0;
  for (std::size_t m = 1; m <= count; ++m)
    if (of_a_[m] + of_b_[m] < of_a_[from] + of_b_[from]) from = m;
  parts_.assign(half.size(), 0.0);
  widest_ = -1;
  for (std::size_t s = 0; s < count; ++s) {
    const auto joint = static_cast<std::size_t>(steps_[s].joint);
    parts_[joint] += s < from ? of_a_[s + 1] - of_a_[s] : of_b_[s] - of_b_[s + 1];
    const bool wider = widest_ < 0 || parts_[joint] > parts_[static_cast<std::size_t>(widest_)];
    if (parts_[joint] > 0 && wider) widest_ = steps_[s].joint;
  }
  const double whole = of_a_[from] + of_b_[from];
  return whole > 0 ? whole * kOutward + kPlace : 0;
}

}  // namespace raygauge
