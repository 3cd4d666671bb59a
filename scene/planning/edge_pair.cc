// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// What bounds of a few operations lose of the numbers that they are made of, with room to spare.
constexpr double kRounding = 1e-13;

double distance_to_segment(const Eigen::Vector3d& first, const Eigen::Vector3d& last) {
  const Eigen::Vector3d way = last - first;
  const double square = way.squaredNorm(), along = -first.dot(way);
  if (along <= 0 || square == 0) return first.norm();
  if (along >= square) return last.norm();
  return (first + along / square * way).norm();
}

// A spin ω moves h_S(Rᵀu) by at most |ω|² reach T²/8 from the chord; the errors of velocity and spin as
// PlaneSteps has them.
Sagging of_motion(const Motion& motion, double reach, double from, double to) {
  if (!(from < to)) return {};
  const MotionBound bound = motion.bound(from, to);
  const double T = to - from;
  constexpr double kOutward = 1 + 1e-12;
  return {bound.spin.squaredNorm() * reach * T * T / 8 * kOutward,
          (bound.velocity_error / 2 + 2 * bound.spin_error * reach) * T * kOutward};
}

}  // namespace

// With m the mean and d the difference of both ends the least value is m - sag - d²/(16 sag), where it is not
// at an end.
double least_between(double first, double last, const Sagging& sagging) noexcept {
  const double sag = sagging.sag, d = std::fabs(first - last);
  double least = std::min(first, last);
  if (4 * sag > d) least = (first + last) / 2 - sag - d * d / (16 * sag);
  return least - kRounding * (std::fabs(first) + std::fabs(last) + sag) - sagging.drift;
}

EdgeShape& EdgeTests::measured(int number, std::size_t shape) {
  EdgeBody& of = bodies_[static_cast<std::size_t>(number)];
  EdgeShape& found = of.shapes[shape];
  if (of.is_obstacle() || found.edge == edge_) return found;
  found.edge = edge_;
  chain_.bound(of.link, found.center_reach, found.of_center);
  chain_.bound(of.link, found.core_reach, found.of_points);
  return found;
}

Eigen::Vector3d EdgeTests::to_scene(const EdgePair& pair, int moment, const Eigen::Vector3d& u) const {
  if (pair.carrier < 0) return u;
  return stage_.link(moment, pair.carrier).R * u;
}

Eigen::Vector3d EdgeTests::to_carrier(const EdgePair& pair, int moment, const Eigen::Vector3d& u) const {
  if (pair.carrier < 0) return u;
  return stage_.link(moment, pair.carrier).R.transpose() * u;
}

Sagging EdgeTests::sagging(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int first,
                           int last) {
  const double from = stage_.time(first), to = stage_.time(last);
  Sagging all;
  if (first == last) return all;
  all.sag = measured(pair.a, shape_a).of_points.sag(pair.left_out_a, to - from);
  const EdgeShape& other = measured(pair.b, shape_b);
  if (!body(pair.b).is_obstacle()) {
    all.sag += other.of_points.sag(pair.left_out_b, to - from);
  } else if (!body(pair.b).stands) {
    const Sagging own = of_motion(*body(pair.b).body.motion, other.reach, from, to);
    all.sag += own.sag;
    all.drift = own.drift;
  }
  return all;
}

double EdgeTests::slack(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  return stage_.error(moment, a).of_points(a.shapes[shape_a].reach) +
         stage_.error(moment, b).of_points(b.shapes[shape_b].reach);
}

double EdgeTests::loss(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  const EdgeShape &one = a.shapes[shape_a], &other = b.shapes[shape_b];
  const Frame &at_a = stage_.at(moment, a), &at_b = stage_.at(moment, b);
  const double way = at_a.t.lpNorm<1>() + at_b.t.lpNorm<1>();
  double loss = slack(pair, shape_a, shape_b, moment);
  loss += kRounding * (way + one.part->turned_magnitude + other.part->turned_magnitude);
  if (pair.carrier >= 0) loss += (chain_.error(pair.carrier).turn + 1e-15) * (way + one.reach + other.reach);
  return loss;
}

void EdgeTests::stand(const EdgePair& pair, int moment, Matrix3& R_a, Matrix3& R_b, Vector3& way) const {
  const Frame &at_a = stage_.at(moment, body(pair.a)), &at_b = stage_.at(moment, body(pair.b));
  const auto take = [&](const Eigen::Matrix3d& R, Matrix3& seen) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = to_carrier(pair, moment, R.col(k));
      seen.column[k] = {axis[0], axis[1], axis[2]};
    }
  };
  take(at_a.R, R_a);
  take(at_b.R, R_b);
  const Eigen::Vector3d between = to_carrier(pair, moment, at_b.t - at_a.t);
  way = {between[0], between[1], between[2]};
}

double EdgeTests::planes_apart(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment,
                               const Eigen::Vector3d& u) const {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  const EdgeShape &one = a.shapes[shape_a], &other = b.shapes[shape_b];
  const Frame &at_a = stage_.at(moment, a), &at_b = stage_.at(moment, b);
  const Eigen::Vector3d normal = to_scene(pair, moment, u), way = at_b.t - at_a.t;
  const Eigen::Vector3d inner_a = -(at_a.R.transpose() * normal), inner_b = at_b.R.transpose() * normal;
  Eigen::Vector3d point;
  const double h = other.part->set->support_unchecked(inner_b.data(), point.data()) +
                   one.part->set->support_unchecked(inner_a.data(), point.data()) + normal.dot(way);
  const double size =
      at_a.t.lpNorm<1>() + at_b.t.lpNorm<1>() + one.part->turned_magnitude + other.part->turned_magnitude;
  double loss = 2 * ConvexSet::rounding_error(3) * normal.lpNorm<1>() * size;
  loss += slack(pair, shape_a, shape_b, moment);
  if (pair.carrier >= 0) {  // whose rotation is rounded, too
    loss += (chain_.error(pair.carrier).turn + 1e-15) * (way.norm() + one.reach + other.reach);
  }
  const double apart = -h - loss;
  if (!(apart < kInfinity)) return -kInfinity;
  return apart - kRounding * std::fabs(apart);  // for the length of u
}

double EdgeTests::ball_gap(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  const EdgeShape &one = a.shapes[shape_a], &other = b.shapes[shape_b];
  const Frame &at_a = stage_.at(moment, a), &at_b = stage_.at(moment, b);
  return (at_a.t - at_b.t + at_a.R * one.center - at_b.R * other.center).norm() - one.radius - other.radius;
}

double EdgeTests::likely_gap(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b,
                             int moment) const {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  const EdgeShape &one = a.shapes[shape_a], &other = b.shapes[shape_b];
  const Frame& at_a = stage_.at(moment, a);
  const Eigen::Vector3d middle = at_a.R * one.center + at_a.t;
  if (b.is_obstacle() && b.stands) {
    const Eigen::Vector3d x = b.at.R.transpose() * (middle - b.at.t);
    const Eigen::Vector3d beyond = (other.low - x).cwiseMax(x - other.high);
    const double outside = beyond.cwiseMax(0.0).norm();
    return (outside > 0 ? outside : beyond.maxCoeff()) - one.thickness;
  }
  const Frame& at_b = stage_.at(moment, b);
  return (middle - at_b.R * other.center - at_b.t).norm() - one.thickness - other.thickness;
}

// The middle of the ball stays within its sag of the chord, which is in the box around both ends.
bool EdgeTests::box_apart(const EdgeBody& a, const EdgeShape& one, const EdgeBody& b, const EdgeShape& other,
                          int first, int last, double enough) const {
  const Frame &from = stage_.at(first, a), &to = stage_.at(last, a);
  const Eigen::Vector3d x = b.at.R.transpose() * (from.R * one.center + from.t - b.at.t);
  const Eigen::Vector3d y = b.at.R.transpose() * (to.R * one.center + to.t - b.at.t);
  const Eigen::Vector3d below = other.low - x.cwiseMax(y), above = x.cwiseMin(y) - other.high;
  return below.cwiseMax(above).cwiseMax(0.0).norm() > enough;
}

bool EdgeTests::balls_apart(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int first,
                            int last, double margin) {
  const EdgeBody &a = body(pair.a), &b = body(pair.b);
  const EdgeShape &one = measured(pair.a, shape_a), &other = measured(pair.b, shape_b);
  const double from = stage_.time(first), to = stage_.time(last), T = to - from;
  double sag_a = 0, sag_b = 0;
  if (first != last) {
    sag_a = one.of_center.sag(pair.left_out_a, T);
    if (!b.is_obstacle()) sag_b = other.of_center.sag(pair.left_out_b, T);
    if (b.is_obstacle() && !b.stands) {
      const Sagging own = of_motion(*b.body.motion, other.reach, from, to);
      sag_b = own.sag + own.drift;
    }
  }
  const auto apart = [&](int moment) {
    const Frame &at_a = stage_.at(moment, a), &at_b = stage_.at(moment, b);
    return to_carrier(pair, moment, at_a.t - at_b.t + at_a.R * one.center - at_b.R * other.center);
  };
  const Eigen::Vector3d before = apart(first), after = first == last ? before : apart(last);
  const double slacks = std::max(slack(pair, shape_a, shape_b, first), slack(pair, shape_a, shape_b, last));
  const double size = stage_.at(first, a).t.norm() + stage_.at(first, b).t.norm() +
                      stage_.at(last, a).t.norm() + stage_.at(last, b).t.norm() + one.reach + other.reach;
  double loss = slacks + kRounding * size;
  if (pair.carrier >= 0) loss += chain_.error(pair.carrier).turn * (before.norm() + after.norm());
  const double enough = margin + one.radius + sag_a + sag_b + loss;
  if (distance_to_segment(before, after) > (enough + other.radius) * (1 + kRounding)) return true;
  if (!b.is_obstacle() || !b.stands) return false;
  return box_apart(a, one, b, other, first, last, enough * (1 + kRounding));
}

}  // namespace raygauge
