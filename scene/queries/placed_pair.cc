// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/placed_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/ball.h"

namespace raygauge {
namespace {

// Room for the rounding of the few operations of a bound, relative to what they are made of.
constexpr double kRounding = 1e-13;
constexpr double kOutward = 1 + kRounding;

// What h(u) of a placed set may lose: rounding_error(n) Σ_k |u_k| m_k with the magnitudes of LinearImage,
// each at most |t_k| + `turned` (turned_magnitude).
double support_error(const SmallVector& u, double turned, const Placement& at) {
  const int n = static_cast<int>(u.size());
  return 2 * ConvexSet::rounding_error(n) * u.lpNorm<1>() * (at.t.lpNorm<1>() + turned);
}

}  // namespace

void PlacedBody::place(const Placement& at) {
  at_ = at;
  posed_ = false;
}

void PlacedBody::check() {
  if (at_.defect != Placement::kUnchecked) return;
  pose_.assign(at_.R.data(), at_.t.data());
  at_.defect = pose_.defect();
}

Posed PlacedBody::posed(int number) {
  if (!posed_) pose_.assign_checked(at_.R.data(), at_.t.data(), at_.defect);
  posed_ = true;
  return {set(number), pose_};
}

PlacedPair::PlacedPair(int dimension)
    : dimension_(dimension),
      a_(dimension),
      b_(dimension),
      ball_(std::make_shared<Ball>(Vector::Zero(dimension), 1.0)),
      pose_Q_(dimension) {}

void PlacedPair::bind(const Body& a, const Body& b, const SceneMetric& metric) {
  a_.bind(a);
  b_.bind(b);
  metric_ = &metric;
  bounded_ = a.is_bounded() && b.is_bounded();
  outer_radius_ = 1;
  if (metric.euclidean()) return;
  const BoundingBall ball = bounding_ball(*metric.Q);
  outer_radius_ = (ball.center.norm() + ball.radius) * kOutward;
  magnitude_Q_.resize(dimension_);
  metric.Q->magnitude_unchecked(magnitude_Q_.data());
}

void PlacedPair::place(const Placement& a, const Placement& b, const Placement* metric_at) {
  a_.place(a);
  b_.place(b);
  if (euclidean()) return;
  Placement turned = Placement::identity(dimension_);
  if (metric_at != nullptr) turned.R = metric_at->R;
  pose_Q_.assign(turned.R.data(), turned.t.data());
  Q_.emplace(*metric_->Q, pose_Q_);
}

double PlacedPair::ball_bound(const double* center_a, const double* center_b) const {
  const double radii = a_.body().ball.radius + b_.body().ball.radius;
  double square = 0, size = radii;
  for (int k = 0; k < dimension_; ++k) {
    const double apart = center_a[k] - center_b[k];
    square += apart * apart;
    size += std::fabs(center_a[k]) + std::fabs(center_b[k]);
  }
  return std::max(0.0, std::sqrt(square) - radii - kRounding * size) / (outer_radius_ * kOutward);
}

double PlacedPair::part_ball_bound(PartNumbers parts) const {
  return bound_of_balls(a_.part(parts.a).ball, b_.part(parts.b).ball);
}

double PlacedPair::bound_of_balls(const BoundingBall& ball_a, const BoundingBall& ball_b) const {
  const SmallVector center_a = a_.at().R * ball_a.center + a_.at().t;
  const SmallVector center_b = b_.at().R * ball_b.center + b_.at().t;
  const double radii = ball_a.radius + ball_b.radius;
  const double rounding =
      kRounding * (a_.at().t.norm() + b_.at().t.norm() + a_.body().reach + b_.body().reach + radii);
  return std::max(0.0, (center_a - center_b).norm() - radii - rounding) / (outer_radius_ * kOutward);
}

// -h_A(u), A = b - a, rounding errors included, or less; the support points are in the frames of the bodies.
double PlacedPair::depth_along(PartNumbers parts, const SmallVector& u, SmallVector& point_a,
                               SmallVector& point_b) const {
  const BodyPart& part_a = a_.part(parts.a);
  const BodyPart& part_b = b_.part(parts.b);
  point_a.resize(dimension_);
  point_b.resize(dimension_);
  const SmallVector inner_a = -a_.at().turned_back(u);
  const SmallVector inner_b = b_.at().turned_back(u);
  const double h = part_b.set->support_unchecked(inner_b.data(), point_b.data()) +
                   part_a.set->support_unchecked(inner_a.data(), point_a.data()) +
                   u.dot(b_.at().t - a_.at().t);
  const double error =
      support_error(u, part_a.turned_magnitude, a_.at()) + support_error(u, part_b.turned_magnitude, b_.at());
  return -(h + error);
}

// The half-space does not turn: its plane is the only one, and u is its normal but for rounding.
double PlacedPair::apart_from_plane(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  constexpr double kSame = 1e-14;
  check_placements();
  half_space_.bind(a_.posed(0), b_.posed(0));
  const SmallVector normal = half_space_.direction();
  const double length = normal.norm(), gap = half_space_.gap_lower() / length;
  if (!((u - normal / length).norm() <= kSame)) return -kInfinity;
  const SmallVector point = half_space_.point(), way = gap / length * normal;
  arm_a = a_.body().is_bounded() ? point : SmallVector(point + way);
  arm_b = b_.body().is_bounded() ? point : SmallVector(point - way);
  arm_a -= a_.at().t;
  arm_b -= b_.at().t;
  return gap > 0 ? gap / kOutward : gap * kOutward;
}

double PlacedPair::apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  if (is_mesh({0, 0})) {  // no plane need lie between
    arm_a = arm_b = SmallVector::Zero(dimension_);
    return -kInfinity;
  }
  if (!bounded_) return apart_from_plane(u, arm_a, arm_b);
  SmallVector point_a, point_b;
  const double depth = depth_along({0, 0}, u, point_a, point_b);
  arm_a = a_.at().turned(point_a);
  arm_b = b_.at().turned(point_b);
  return depth / (u.norm() * (depth > 0 ? kOutward : 1.0));
}

// Weak duality (10) at u: -h_A(u) / h_Q(-u).
double PlacedPair::plane_bound(PartNumbers parts, const SmallVector& u) {
  if (is_mesh(parts)) return 0;
  if (!bounded_) {
    check_placements();
    half_space_.bind(a_.posed(parts.a), b_.posed(parts.b));
    return half_space_.lower_bound(unit_ball());
  }
  SmallVector point, other;
  const double depth = depth_along(parts, u, point, other);
  if (!(depth > 0)) return 0;
  if (euclidean()) return depth / (u.norm() * kOutward);
  const SmallVector minus = -u;
  const double h_Q = Q_->support_unchecked(minus.data(), point.data()) +
                     support_error(u, turned_magnitude(magnitude_Q_), Placement::identity(dimension_));
  return h_Q > 0 ? depth / (h_Q * kOutward) : 0.0;
}

double PlacedPair::plane_rate(const SmallVector& u) const {
  if (euclidean()) return kOutward;
  SmallVector point(dimension_);
  const SmallVector minus = -u;
  return u.norm() / Q_->support_unchecked(minus.data(), point.data()) * (1 + 1e-9);
}

void PlacedPair::check_placements() {
  a_.check();
  b_.check();
}

bool PlacedPair::is_mesh(PartNumbers parts) const noexcept {
  return as_mesh(a_.set(parts.a)) != nullptr || as_mesh(b_.set(parts.b)) != nullptr;
}

}  // namespace raygauge
