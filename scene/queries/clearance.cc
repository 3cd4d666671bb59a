// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "scene/queries/effects.h"
#include "scene/queries/plane_steps.h"
#include "scene/queries/riders.h"
#include "scene/queries/rows.h"

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
  if (speed > 0) return speed;
  return speed <= 0 ? 0.0 : kInfinity;  // no bound where it is no number
}

// By how fast the distances at both ends can fall.
void bound_by_speeds(const PartWatch& watch, Span& span) {
  const double from = span.first.time;
  const double to = span.last.time;
  const double length = to - from;
  double s = length / 2;
  if (span.first.lower > 0 && span.last.lower > 0) {
    const double v = falling_speed(watch, span.first, from, to, true);
    const double w = falling_speed(watch, span.last, from, to, false);
    if (v + w > 0 && v + w < kInfinity) s = (span.first.lower - span.last.lower + w * length) / (v + w);
    const double at = std::clamp(s, 0.0, length);
    const double rounding = 1e-13 * (span.first.lower + span.last.lower + (v + w) * length);
    const double bound = std::max(span.first.lower - v * at, span.last.lower - w * (length - at)) - rounding;
    if (bound > 0) span.bound = bound;  // not where it is no number
  }
  span.split = from + std::clamp(s, 0.1 * length, 0.9 * length);
}

/// The search for the least distance of one pair of parts, cut where it cannot be below `best`.
class ClearanceSearch {
 public:
  ClearanceSearch(PartWatch& watch, const ContinuousOptions& options, ClearanceResult& best)
      : watch_(watch), planes_(watch), options_(options), best_(best) {}

  /// Returns a lower bound on the distance of this pair, or on `best` where that is less.
  double run() {
    seed();
    double given_up = kInfinity;  // the least bound of spans that cannot be split
    while (!spans_.empty()) {
      const Span top = spans_.top();
      if (is_closed(top.bound) || is_final(top.bound) || is_over())
        return std::min({top.bound, given_up, best_.upper});
      spans_.pop();
      if (!(top.first.time < top.split && top.split < top.last.time)) {
        given_up = std::min(given_up, top.bound);
        continue;
      }
      const PartLook middle = look(top.split);
      add(top.first, middle);
      add(middle, top.last);
    }
    return std::min(given_up, best_.upper);
  }

 private:
  bool is_closed(double bound) const {
    if (best_.touches || best_.upper <= options_.contact) return true;
    return best_.upper - bound <= options_.tolerance * best_.upper;
  }

  // No bound of a span gets above those of the looks at its ends: where these leave more than the tolerance,
  // nothing is gained beyond them.
  bool is_final(double bound) const {
    return least_lower_ > 0 && !is_closed(least_lower_) && bound >= (1 - options_.tolerance) * least_lower_;
  }

  // Once a look has proven nothing, only common points are looked for, for a while.
  bool is_over() const {
    constexpr std::int64_t kStepsWithoutHope = 2'000;
    return steps_ >= options_.max_steps || hopeless_steps_ >= kStepsWithoutHope ||
           (options_.stop && options_.stop());
  }

  PartLook look(double t) {
    ++steps_;
    ++best_.steps;
    PartLook seen = watch_.at(t);
    least_lower_ = std::min(least_lower_, seen.lower);
    if (least_lower_ == 0) ++hopeless_steps_;
    if (seen.meets) seen.upper = 0;
    if (seen.upper < best_.upper) {
      best_.upper = seen.upper;
      best_.time = t;
      best_.touches = seen.meets;
      best_.at_time = seen.answer;
    }
    return seen;
  }

  void add(const PartLook& first, const PartLook& last) {
    Span span{first, last, 0, 0};
    bound_by_speeds(watch_, span);
    if (!is_closed(span.bound)) bound_by_planes(span);
    if (span.bound < best_.upper) spans_.push(std::move(span));
  }

  // By planes between the bodies at the end where they are nearer: over short times they lose far less than
  // the speeds of both bodies say, where the distance hardly changes.
  void bound_by_planes(Span& span) {
    if (!watch_.metric().euclidean() || !watch_.is_convex()) return;
    const PairMotion motion(watch_, span.first.time, span.last.time);
    const bool forward = span.first.lower <= span.last.lower;
    const PartLook& near = forward ? span.first : span.last;
    const double end = forward ? span.last.time : span.first.time;
    span.bound = std::max(span.bound, planes_.least_until(near, end, motion));
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
  PlaneSteps planes_;
  const ContinuousOptions& options_;
  ClearanceResult& best_;
  std::priority_queue<Span> spans_;
  double least_lower_ = kInfinity;
  std::int64_t hopeless_steps_ = 0;
  std::int64_t steps_ = 0;
};

// The first moment of contact, where there is one at best.time: time_of_impact() leads to where the bodies
// are near enough, from there a bisection to where they meet.
void find_first_contact(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                        const Body* metric_body, const ContinuousOptions& options, ClearanceResult& best) {
  ContinuousOptions before = options;
  before.to = best.time;
  const ImpactResult impact = time_of_impact(solver, a, b, before);
  best.steps += impact.steps;
  best.no_contact_before = impact.lower;
  if (impact.outcome != ImpactResult::Outcome::contact) return;
  PartWatch watch(solver, a, b, metric, metric_body);
  double low = impact.upper, middle = low;
  while (low <= middle && middle < best.time) {
    ++best.steps;
    const PartLook look = watch.at(middle, true);
    if (look.meets) {
      best.time = middle;
      best.at_time = look.answer;
    } else {
      low = middle;
    }
    const double next = low + (best.time - low) / 2;
    if (next == middle || next == low) break;
    middle = next;
  }
}

ClearanceResult find_clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                               const Body* metric_body, const ContinuousOptions& options) {
  solver.set_tolerance(std::min(PartWatch::kStepTolerance, options.tolerance / 4));
  ClearanceResult best;
  best.upper = best.lower = kInfinity;
  best.time = best.no_contact_before = options.from;
  for (const PartPair& pair : part_pairs(a, b, options.from)) {
    PartWatch watch(solver, pair.a, pair.b, metric, metric_body);
    const double before = best.upper;
    best.lower = std::min(best.lower, ClearanceSearch(watch, options, best).run());
    if (best.upper < before) pair.name_in(best.at_time);
  }
  best.lower = best.touches ? 0.0 : std::min(best.lower, best.upper);
  if (best.touches) find_first_contact(solver, a, b, metric, metric_body, options, best);
  return best;
}

}  // namespace

ClearanceResult clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                          const Body* metric_body, const ContinuousOptions& options) {
  const Riders riders(a, b, metric.euclidean());
  ClearanceResult found = find_clearance(solver, riders.a(), riders.b(), metric, metric_body, options);
  riders.to_scene(found.time, found.at_time);
  return found;
}

namespace {

void answer(const ContinuousQuestion& question, PairSolver& solver, SceneRecord& row) {
  const ClearanceResult found =
      clearance(solver, question.a, question.b, question.metric, question.metric_body, question.options);
  row.time = found.time;
  if (found.touches) {
    row.time_lower = found.no_contact_before;
    row.time_upper = found.time;
  }
  row.lower = found.lower;
  row.upper = found.upper;
  row.distance = found.upper;
  row.status = SceneStatus::undecided;
  if (found.lower > 0) row.status = SceneStatus::separated;
  if (found.touches) row.status = SceneStatus::intersecting;
  take_points(found.at_time, row);
}

SceneEvent event(const SceneRecord& row, const std::string& unit) {
  if (row.status == SceneStatus::intersecting) {
    SceneEvent event = event_of_kind(EventKind::contact, row, row.time);
    event.text = std::isnan(row.time_lower)
                     ? "they meet at " + event_number(row.time) + " s"
                     : "they meet, first in " + event_interval(row.time_lower, row.time);
    return event;
  }
  const bool apart = row.lower > 0;
  SceneEvent event = event_of_kind(apart ? EventKind::near : EventKind::undecided, row, row.time);
  event.value = row.lower;
  event.text = (apart ? "never closer than " + event_bound(row.lower) + unit : "meet, or nearly: undecided") +
               "; " + event_number(row.upper) + unit + " at " + event_number(row.time) + " s";
  return event;
}

}  // namespace

Effect clearance_effect() noexcept {
  return {SceneEffects::clearance, "clearance", "clearance: branch and bound over time", answer, event};
}

}  // namespace raygauge
