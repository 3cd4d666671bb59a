// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "engine/scene/part_watch.h"

namespace raygauge {
namespace {

/// An interval between two looks, and a lower bound on the distance within it.
struct Span {
  PartLook first, last;
  double bound = 0;
  double split = 0;  ///< where it is least

  friend bool operator<(const Span& x, const Span& y) { return x.bound > y.bound; }  // the least on top
};

// How fast, at most, the bound of `look` falls as one goes from it within [from, to]: forward or backward.
double falling_speed(const PartWatch& watch, const PartLook& look, double from, double to, bool forward) {
  const SmallVector u = forward ? look.normal : SmallVector(-look.normal);
  double speed = watch.closing_speed(u, from, to);
  if (const Body* metric_body = watch.metric_body()) {
    const double apart = (watch.a().motion->at(look.time).t - watch.b().motion->at(look.time).t).norm();
    const double travelled =
        (watch.a().motion->bound(from, to).speed(0) + watch.b().motion->bound(from, to).speed(0)) *
        (to - from);
    const MotionBound turning = metric_body->motion->bound(from, to);
    speed += look.normal.norm() * (turning.spin.norm() + turning.spin_error) *
             (apart + travelled + watch.a().reach + watch.b().reach) * (1 + 1e-13);
  }
  return std::max(0.0, speed);
}

void bound_span(const PartWatch& watch, Span& span) {
  const double from = span.first.time;
  const double to = span.last.time;
  const double length = to - from;
  double s = length / 2;
  if (span.first.lower > 0 && span.last.lower > 0) {
    const double v = falling_speed(watch, span.first, from, to, true);
    const double w = falling_speed(watch, span.last, from, to, false);
    if (v + w > 0) s = (span.first.lower - span.last.lower + w * length) / (v + w);
    const double at = std::clamp(s, 0.0, length);
    const double rounding = 1e-13 * (span.first.lower + span.last.lower + (v + w) * length);
    span.bound =
        std::max(0.0, std::max(span.first.lower - v * at, span.last.lower - w * (length - at)) - rounding);
  }
  span.split = from + std::clamp(s, 0.1 * length, 0.9 * length);
}

/// The search for the least distance of one pair of parts, cut where it cannot be below `best`.
class ClearanceSearch {
 public:
  ClearanceSearch(PartWatch& watch, const ContinuousOptions& options, ClearanceResult& best)
      : watch_(watch), options_(options), best_(best) {}

  /// Returns a lower bound on the distance of this pair, or on `best` where that is less.
  double run() {
    seed();
    while (!spans_.empty()) {
      const Span top = spans_.top();
      if (is_closed(top.bound) || steps_ >= options_.max_steps) return std::min(top.bound, best_.upper);
      spans_.pop();
      if (!(top.first.time < top.split && top.split < top.last.time)) return std::min(top.bound, best_.upper);
      const PartLook middle = look(top.split);
      add(top.first, middle);
      add(middle, top.last);
    }
    return best_.upper;
  }

 private:
  bool is_closed(double bound) const {
    if (best_.touches || best_.upper <= options_.contact) return true;
    return best_.upper - bound <= options_.tolerance * best_.upper;
  }

  PartLook look(double t) {
    ++steps_;
    ++best_.steps;
    PartLook seen = watch_.at(t);
    if (seen.upper < best_.upper) {
      best_.upper = seen.upper;
      best_.time = t;
      best_.touches = seen.answer.intersecting();
      best_.at_time = seen.answer;
    }
    return seen;
  }

  void add(const PartLook& first, const PartLook& last) {
    Span span{first, last, 0, 0};
    bound_span(watch_, span);
    if (span.bound < best_.upper) spans_.push(std::move(span));
  }

  void seed() {
    PartLook before = look(options_.from);
    double t = options_.from;
    if (t >= options_.to) {
      spans_.push({before, before, before.lower, t});
      return;
    }
    while (t < options_.to) {
      t = watch_.end_of_piece(t, options_.to);
      const PartLook after = look(t);
      add(before, after);
      before = after;
    }
  }

  PartWatch& watch_;
  const ContinuousOptions& options_;
  ClearanceResult& best_;
  std::priority_queue<Span> spans_;
  std::int64_t steps_ = 0;
};

}  // namespace

ClearanceResult clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                          const Body* metric_body, const ContinuousOptions& options) {
  solver.set_tolerance(std::min(PartWatch::kStepTolerance, options.tolerance / 4));
  ClearanceResult best;
  best.upper = best.lower = kInfinity;
  best.time = options.from;
  for (const auto& [part_a, part_b] : part_pairs(a, b, options.from)) {
    PartWatch watch(solver, part_a, part_b, metric, metric_body);
    best.lower = std::min(best.lower, ClearanceSearch(watch, options, best).run());
  }
  best.lower = best.touches ? 0.0 : std::min(best.lower, best.upper);
  return best;
}

}  // namespace raygauge
