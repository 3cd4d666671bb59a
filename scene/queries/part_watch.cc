// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/part_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

bool is_convex_body(const Body& body) {
  return std::none_of(body.parts.begin(), body.parts.end(),
                      [](const BodyPart& part) { return as_mesh(*part.set) != nullptr; });
}

/// The body of one part of `body`.
Body part_of(const Body& body, int number) {
  const BodyPart& part = body.parts[static_cast<std::size_t>(number)];
  Body single;
  single.parts = {part};
  single.motion = body.motion;
  single.ball = part.ball;
  single.reach = part.reach;
  single.core_reach = part.core_reach;
  return single;
}

}  // namespace

PartWatch::PartWatch(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                     const Body* metric_body)
    : convex_(is_convex_body(a) && is_convex_body(b)),
      solver_(solver),
      a_(a),
      b_(b),
      metric_(metric),
      metric_body_(metric_body),
      placed_at_(std::numeric_limits<double>::quiet_NaN()) {
  solver_.bind(a, b, metric);
}

// A metric that turns by e more moves the planes of a point x by e |x|.
void PartWatch::place(double t) {
  if (t == placed_at_) return;
  const Placement at_a = a_.motion->at(t);
  const Placement at_b = b_.motion->at(t);
  error_a_ = a_.motion->error_at(t);
  error_b_ = b_.motion->error_at(t);
  slack_ = error_a_.of_points(a_.reach) + error_b_.of_points(b_.reach);
  if (metric_body_ == nullptr) {
    solver_.place(at_a, at_b);
  } else {
    const Placement at_metric = metric_body_->motion->at(t);
    solver_.place(at_a, at_b, &at_metric);
    slack_ += metric_body_->motion->error_at(t).turn * ((at_a.t - at_b.t).norm() + a_.reach + b_.reach);
  }
  placed_at_ = t;
}

PartLook PartWatch::at(double t, bool closest_points) {
  place(t);
  PartLook look;
  look.time = t;
  look.answer = solver_.distance(memory_, kInfinity, closest_points, false);
  look.normal = look.answer.normal;
  look.upper = look.answer.upper + slack_in_metric();
  if (!(look.upper >= 0)) look.upper = kInfinity;
  const double lower = look.answer.lower - slack_ * look.answer.rate;
  if (look.normal.size() > 0 && lower > 0 && lower <= look.upper) look.lower = lower;
  look.meets = look.answer.intersecting() && meets_wherever_shifted(look.answer);
  return look;
}

// A set of vectors by which a body can be shifted so that it still meets the other is convex: if it holds the
// corners of a cross-polytope it holds the ball inside, and then the bodies meet for all support functions
// that differ by no more than its radius. Of bodies of several parts that holds for each pair of parts: all
// corners have to meet by the same one.
bool PartWatch::meets_wherever_shifted(const PairAnswer& unmoved) {
  if (slack_ == 0) return true;
  if (!(slack_ < kInfinity)) return false;
  if (!convex_) return solver_.meets_if_moved(slack_);
  const int n = a_.dimension();
  const Placement at_a = solver_.placement_a(), at_b = solver_.placement_b();
  bool meets = true;
  for (int k = 0; k < 2 * n && meets; ++k) {
    Placement shifted = at_b;
    shifted.t[k / 2] += (k % 2 == 0 ? 4 : -4) * slack_;
    Placement at_metric;
    if (metric_body_ != nullptr) at_metric = metric_body_->motion->at(placed_at_);
    solver_.place(at_a, shifted, metric_body_ == nullptr ? nullptr : &at_metric);
    const PairAnswer& moved = solver_.distance(memory_, kInfinity, false, false);
    meets = moved.intersecting() && moved.part_a == unmoved.part_a && moved.part_b == unmoved.part_b;
  }
  placed_at_ = std::numeric_limits<double>::quiet_NaN();
  return meets;
}

// |x| in the metric is at most Σ |x_k| max(|e_k|, |-e_k|).
double PartWatch::slack_in_metric() {
  if (metric_.euclidean() || slack_ == 0) return slack_;
  if (longest_unit_ == 0) {
    DistanceSolver solver;
    const int n = a_.dimension();
    for (int k = 0; k < 2 * n; ++k) {
      Vector unit = Vector::Zero(n);
      unit[k / 2] = k % 2 == 0 ? 1 : -1;
      longest_unit_ = std::max(longest_unit_, solver.solve(PointSet(unit), *metric_.Q).upper);
    }
    longest_unit_ *= std::sqrt(n) * (1 + 1e-9);
  }
  return slack_ * longest_unit_;
}

double PartWatch::apart_along(double t, const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  place(t);
  const double apart = solver_.apart_along(u, arm_a, arm_b) - slack_;
  return apart < kInfinity ? apart : -kInfinity;
}

double PartWatch::end_of_piece(double t, double to) const {
  double end = std::min({to, a_.motion->next_break(t), b_.motion->next_break(t)});
  if (metric_body_ != nullptr) end = std::min(end, metric_body_->motion->next_break(t));
  return end;
}

double PartWatch::closing_speed(const SmallVector& u, double from, double to) const {
  return closing_speed(u, a_.motion->bound(from, to), b_.motion->bound(from, to));
}

double PartWatch::closing_speed(const SmallVector& u, const MotionBound& a, const MotionBound& b) const {
  if (!convex_) {
    MotionBound between = b;  // of the origins
    between.velocity -= a.velocity;
    between.velocity_error += a.velocity_error + 1e-13 * (a.velocity.lpNorm<1>() + b.velocity.lpNorm<1>());
    between.spin.setZero();
    between.spin_error = 0;
    MotionBound turning_a = a, turning_b = b;
    turning_a.velocity.setZero();
    turning_b.velocity.setZero();
    turning_a.velocity_error = turning_b.velocity_error = 0;
    return between.speed(0) + turning_a.speed(a_.reach) + turning_b.speed(b_.reach);
  }
  const SmallVector minus = -u;
  return b.speed_along(u, b_.core_reach) + a.speed_along(minus, a_.core_reach);
}

std::vector<PartPair> part_pairs(const Body& a, const Body& b, double t) {
  struct Entry {
    double apart;
    int a, b;
  };
  const Placement at_a = a.motion->at(t);
  const Placement at_b = b.motion->at(t);
  std::vector<Entry> entries;
  for (int i = 0; i < static_cast<int>(a.parts.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.parts.size()); ++j) {
      const BoundingBall& ball_a = a.parts[static_cast<std::size_t>(i)].ball;
      const BoundingBall& ball_b = b.parts[static_cast<std::size_t>(j)].ball;
      const SmallVector way = at_a.R * ball_a.center + at_a.t - at_b.R * ball_b.center - at_b.t;
      entries.push_back({way.norm() - ball_a.radius - ball_b.radius, i, j});
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& x, const Entry& y) { return x.apart < y.apart; });
  std::vector<PartPair> pairs;
  for (const auto& [apart, i, j] : entries) pairs.push_back({part_of(a, i), part_of(b, j), {i, j}});
  return pairs;
}

}  // namespace raygauge
