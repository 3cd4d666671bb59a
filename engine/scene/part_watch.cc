// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/scene/part_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Computed placements are those of the exact motion but for this share of what they are computed from.
constexpr double kPlacementRounding = 1e-14;

/// The body of one part of `body`.
Body part_of(const Body& body, const BodyPart& part) {
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
    : solver_(solver),
      a_(a),
      b_(b),
      metric_body_(metric_body),
      pace_a_(a),
      pace_b_(b),
      placed_at_(std::numeric_limits<double>::quiet_NaN()) {
  solver_.bind(a, b, metric);
}

PartWatch::Pace::Pace(const Body& body) : body_(body), start_(body.motion->start()) {
  if (!std::isfinite(start_) || body.motion->is_static()) start_ = kInfinity;
}

double PartWatch::Pace::slack(const Placement& at, double t) {
  const double since = std::max(0.0, t - start_);
  if (since > 0 && !(from_ <= t && t <= to_)) {
    from_ = t;
    to_ = std::min({body_.motion->next_break(t), body_.motion->stop(), t + 1 + std::fabs(t)});
    const MotionBound over = body_.motion->bound(from_, to_);
    if (over.velocity_error + over.spin_error != 0) to_ = t;
    speed_ = body_.motion->bound(from_, to_).speed(body_.reach);
  }
  const double travelled = since > 0 ? speed_ * since : 0.0;
  return kPlacementRounding * (at.t.norm() + body_.reach + travelled);
}

void PartWatch::place(double t) {
  if (t == placed_at_) return;
  const Placement at_a = a_.motion->at(t);
  const Placement at_b = b_.motion->at(t);
  if (metric_body_ == nullptr) {
    solver_.place(at_a, at_b);
  } else {
    const Placement at_metric = metric_body_->motion->at(t);
    solver_.place(at_a, at_b, &at_metric);
  }
  slack_ = pace_a_.slack(at_a, t) + pace_b_.slack(at_b, t);
  placed_at_ = t;
}

PartLook PartWatch::at(double t, bool closest_points) {
  place(t);
  PartLook look;
  look.time = t;
  look.answer = solver_.distance(memory_, kInfinity, closest_points, false);
  look.normal = look.answer.normal;
  look.upper = look.answer.upper;
  if (look.normal.size() > 0) look.lower = std::max(0.0, look.answer.lower - slack_ * look.normal.norm());
  return look;
}

double PartWatch::apart_along(double t, const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  place(t);
  return solver_.apart_along(u, arm_a, arm_b) - slack_;
}

double PartWatch::end_of_piece(double t, double to) const {
  double end = std::min({to, a_.motion->next_break(t), b_.motion->next_break(t)});
  if (metric_body_ != nullptr) end = std::min(end, metric_body_->motion->next_break(t));
  return end;
}

double PartWatch::closing_speed(const SmallVector& u, double from, double to) const {
  const SmallVector minus = -u;
  return b_.motion->bound(from, to).speed_along(u, b_.core_reach) +
         a_.motion->bound(from, to).speed_along(minus, a_.core_reach);
}

std::vector<std::pair<Body, Body>> part_pairs(const Body& a, const Body& b, double t) {
  struct Entry {
    double apart;
    Body a, b;
  };
  const Placement at_a = a.motion->at(t);
  const Placement at_b = b.motion->at(t);
  std::vector<Entry> entries;
  for (const BodyPart& part_a : a.parts) {
    for (const BodyPart& part_b : b.parts) {
      const SmallVector way = at_a.R * part_a.ball.center + at_a.t - at_b.R * part_b.ball.center - at_b.t;
      entries.push_back(
          {way.norm() - part_a.ball.radius - part_b.ball.radius, part_of(a, part_a), part_of(b, part_b)});
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& x, const Entry& y) { return x.apart < y.apart; });
  std::vector<std::pair<Body, Body>> pairs;
  for (Entry& entry : entries) pairs.emplace_back(std::move(entry.a), std::move(entry.b));
  return pairs;
}

}  // namespace raygauge
