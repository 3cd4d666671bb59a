// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/continuous.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Distances on the way need no more digits than a step does.
constexpr double kStepTolerance = 1e-3;

// Computed placements are those of the exact motion but for this share of what they are computed from.
constexpr double kPlacementRounding = 1e-14;

const SceneMetric kEuclidean;

/// The body of one part of `body`.
Body part_of(const Body& body, const BodyPart& part) {
  Body single;
  single.parts = {part};
  single.motion = body.motion;
  single.ball = part.ball;
  single.reach = part.reach;
  return single;
}

double end_of_piece(const Body& a, const Body& b, const Body* metric_body, double t, double to) {
  double end = std::min({to, a.motion->next_break(t), b.motion->next_break(t)});
  if (metric_body != nullptr) end = std::min(end, metric_body->motion->next_break(t));
  return end;
}

// How far computed points of the pair may be from those of the exact motions.
double placement_slack(const Body& body, const Placement& at, double t) {
  const double start = body.motion->start();
  const double since = std::isfinite(start) && !body.motion->is_static() ? t - start : 0.0;
  const double travelled = since > 0 ? body.motion->bound(t, t).speed(body.reach) * since : 0.0;
  return kPlacementRounding * (at.t.norm() + body.reach + travelled);
}

/// How fast the pair can close along u, at most, over [from, to].
double closing_speed(const Body& a, const Body& b, const SmallVector& u, double from, double to) {
  const SmallVector minus = -u;
  return b.motion->bound(from, to).speed_along(u, b.reach) +
         a.motion->bound(from, to).speed_along(minus, a.reach);
}

/// One pair of convex parts on its way: looks at it at a time, and keeps what it saw.
class PartWatch {
 public:
  struct Look {
    double time = 0;
    double lower = 0;  ///< of the exact motion's distance
    double upper = 0;
    SmallVector normal;
    PairAnswer answer;
  };

  PartWatch(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
            const Body* metric_body)
      : solver_(solver), a_(a), b_(b), metric_body_(metric_body) {
    solver_.bind(a, b, metric);
  }

  Look at(double t, bool closest_points = false) {
    const Placement at_a = a_.motion->at(t);
    const Placement at_b = b_.motion->at(t);
    if (metric_body_ == nullptr) {
      solver_.place(at_a, at_b);
    } else {
      const Placement at_metric = metric_body_->motion->at(t);
      solver_.place(at_a, at_b, &at_metric);
    }
    Look look;
    look.time = t;
    look.answer = solver_.distance(memory_, kInfinity, closest_points, false);
    look.normal = look.answer.normal;
    look.upper = look.answer.upper;
    const double slack = placement_slack(a_, at_a, t) + placement_slack(b_, at_b, t);
    if (look.normal.size() > 0) look.lower = std::max(0.0, look.answer.lower - slack * look.normal.norm());
    return look;
  }

  const Body& a() const { return a_; }
  const Body& b() const { return b_; }
  const Body* metric_body() const { return metric_body_; }

 private:
  PairSolver& solver_;
  const Body& a_;
  const Body& b_;
  const Body* metric_body_;
  PairMemory memory_;
};

// The time until which `look` proves that there is no contact; beyond `end` where it is past it.
double safe_until(const PartWatch& watch, const PartWatch::Look& look, double end) {
  const double t = look.time;
  const auto reached = [&](double ahead) {
    const double speed = closing_speed(watch.a(), watch.b(), look.normal, t, ahead);
    if (speed <= 0) return ahead == end ? kInfinity : ahead;
    const double next = t + look.lower / speed * (1 - 1e-13);
    return next > ahead ? (ahead == end ? kInfinity : ahead) : std::nextafter(next, t);
  };
  // Where velocities change over the piece, a bound over less of it may reach farther.
  const double whole = reached(end);
  const double ahead = t + 4 * (std::min(whole, end) - t);
  return whole < end && ahead < end ? std::max(whole, reached(ahead)) : whole;
}

ImpactResult advance(PairSolver& solver, const Body& a, const Body& b, const ContinuousOptions& options) {
  PartWatch watch(solver, a, b, kEuclidean, nullptr);
  ImpactResult result;
  result.lower = result.upper = options.from;
  double t = options.from;
  while (result.steps < options.max_steps) {
    ++result.steps;
    const PartWatch::Look look = watch.at(t);
    result.lower = t;
    if (look.answer.intersecting() || look.upper <= options.contact) {
      result.outcome = ImpactResult::Outcome::contact;
      result.upper = t;
      result.at_upper = watch.at(t, true).answer;
      return result;
    }
    result.upper = options.to;
    if (t >= options.to && look.lower > 0) {
      result.outcome = ImpactResult::Outcome::free;
      return result;
    }
    if (!(look.lower > 0)) return result;
    const double end = end_of_piece(a, b, nullptr, t, options.to);
    const double next = safe_until(watch, look, end);
    if (next == kInfinity && end >= options.to) {
      result.outcome = ImpactResult::Outcome::free;
      result.lower = options.to;
      return result;
    }
    if (!(next > t)) return result;
    t = std::min(next, end);
  }
  return result;
}

/// An interval between two looks, and a lower bound on the distance within it.
struct Span {
  PartWatch::Look first, last;
  double bound = 0;
  double split = 0;  ///< where it is least

  friend bool operator<(const Span& x, const Span& y) { return x.bound > y.bound; }  // the least on top
};

// How fast, at most, the bound of `look` falls as one goes from it within [from, to]: forward or backward.
double falling_speed(const PartWatch& watch, const PartWatch::Look& look, double from, double to,
                     bool forward) {
  const SmallVector u = forward ? look.normal : SmallVector(-look.normal);
  double speed = closing_speed(watch.a(), watch.b(), u, from, to);
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
      const PartWatch::Look middle = look(top.split);
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

  PartWatch::Look look(double t) {
    ++steps_;
    ++best_.steps;
    PartWatch::Look seen = watch_.at(t);
    if (seen.upper < best_.upper) {
      best_.upper = seen.upper;
      best_.time = t;
      best_.touches = seen.answer.intersecting();
      best_.at_time = seen.answer;
    }
    return seen;
  }

  void add(const PartWatch::Look& first, const PartWatch::Look& last) {
    Span span{first, last, 0, 0};
    bound_span(watch_, span);
    if (span.bound < best_.upper) spans_.push(std::move(span));
  }

  void seed() {
    PartWatch::Look before = look(options_.from);
    double t = options_.from;
    if (t >= options_.to) {
      spans_.push({before, before, before.lower, t});
      return;
    }
    while (t < options_.to) {
      t = end_of_piece(watch_.a(), watch_.b(), watch_.metric_body(), t, options_.to);
      const PartWatch::Look after = look(t);
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

/// The pairs of parts of two bodies, those nearest at `t` first.
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

// A later pair of parts touches no sooner than its own bound says; what was proven is the least of all.
void take_sooner(ImpactResult& all, const ImpactResult& one) {
  using Outcome = ImpactResult::Outcome;
  const std::int64_t steps = all.steps + one.steps;
  const double lower = std::min(all.lower, one.lower);
  const bool sooner =
      one.outcome == Outcome::contact && (all.outcome != Outcome::contact || one.upper < all.upper);
  const bool doubtful = one.outcome == Outcome::undecided && all.outcome == Outcome::free;
  if (sooner || doubtful) all = one;
  all.lower = lower;
  all.steps = steps;
}

}  // namespace

ImpactResult time_of_impact(PairSolver& solver, const Body& a, const Body& b,
                            const ContinuousOptions& options) {
  solver.set_tolerance(kStepTolerance);
  ImpactResult result;
  result.outcome = ImpactResult::Outcome::free;
  result.lower = result.upper = options.to;
  ContinuousOptions remaining = options;
  for (const auto& [part_a, part_b] : part_pairs(a, b, options.from)) {
    take_sooner(result, advance(solver, part_a, part_b, remaining));
    if (result.outcome == ImpactResult::Outcome::contact) remaining.to = result.upper;
  }
  return result;
}

ClearanceResult clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                          const Body* metric_body, const ContinuousOptions& options) {
  solver.set_tolerance(std::min(kStepTolerance, options.tolerance / 4));
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
