// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "scene/queries/effects.h"
#include "scene/queries/plane_steps.h"
#include "scene/queries/riders.h"
#include "scene/queries/rows.h"

namespace raygauge {
namespace {

const SceneMetric kEuclidean;

// The time until which `look` proves that there is no contact; beyond `end` where it is past it.
double safe_until(const PartWatch& watch, const PartLook& look, const PairMotion& speeds, double end) {
  const double t = look.time;
  const auto reached = [&](const PairMotion& over, double ahead) {
    const double speed = watch.closing_speed(look.normal, over.a, over.b);
    if (speed <= 0) return ahead == end ? kInfinity : ahead;
    const double next = t + look.lower / speed * (1 - 1e-13);
    if (next > ahead) return ahead == end ? kInfinity : ahead;
    return next > t ? std::nextafter(next, t) : t;  // not where the speed is unbounded or no number
  };
  const double whole = reached(speeds, end);
  const double ahead = t + 4 * (std::min(whole, end) - t);
  if (!speeds.varies() || whole >= end || ahead >= end) return whole;
  return std::max(whole, reached(PairMotion(watch, t, ahead), ahead));
}

// The time until which the balls about the bodies' origins that hold the bodies are apart by more than
// `contact`, as these fly straight: no more than `end`, and t where that proves nothing. Radii are larger
// than rounding errors ask for, and so is the discriminant of the quadratic equation |way + v T| = radius.
double balls_until(PartWatch& watch, const PairMotion& speeds, double t, double end, double contact) {
  constexpr double kMargin = 1e-9;
  if (speeds.varies()) return t;
  watch.place(t);
  const SmallVector& from = watch.placement_a().t;
  const SmallVector way = watch.placement_b().t - from;
  const SmallVector v = speeds.b.velocity - speeds.a.velocity;
  const double reach = watch.a().reach + watch.b().reach + contact;
  const double radius = reach + 2 * watch.slack() + kMargin * (reach + way.norm() + 2 * from.norm());
  const double c = way.squaredNorm() - radius * radius, b = way.dot(v), rounding = 1e-12 * b * b;
  const double discriminant = b * b - v.squaredNorm() * c;
  if (!(c > 0) || !(std::fabs(discriminant) < kInfinity)) return t;
  if (b >= 0 || discriminant < -rounding) return end;
  const double time = c / (std::sqrt(std::max(discriminant, 0.0) + rounding) - b);
  return time > 0 ? std::min(t + (1 - kMargin) * time, end) : t;
}

/// The advance of one pair of parts to its first contact.
class Advance {
 public:
  Advance(PairSolver& solver, const Body& a, const Body& b, const ContinuousOptions& options)
      : watch_(solver, a, b, kEuclidean, nullptr),
        planes_(watch_),
        options_(options),
        t_(options.from),
        speeds_(watch_, t_, t_) {
    result_.lower = result_.upper = options.from;
  }

  ImpactResult run() {
    while (!(options_.stop && options_.stop())) {
      if (result_.steps >= options_.max_steps) {
        look_ahead();
        break;
      }
      const double end = watch_.end_of_piece(t_, options_.to);
      if (end != piece_end_ && t_ < options_.to) {
        enter_piece(end);
        if (t_ >= options_.to) return end_free();
        if (t_ >= end) continue;
      }
      if (!step(end)) break;
    }
    return result_;
  }

 private:
  void enter_piece(double end) {
    speeds_ = PairMotion(watch_, t_, end);
    piece_end_ = end;
    t_ = balls_until(watch_, speeds_, t_, end, options_.contact);
  }

  bool is_contact(const PartLook& look) const { return look.meets || look.upper <= options_.contact; }

  bool end_contact(const PartLook& look) {
    result_.outcome = ImpactResult::Outcome::contact;
    result_.upper = look.time;
    result_.at_upper = look.answer;
    return false;
  }

  /// A look, and how far it leads. False at the end.
  bool step(double end) {
    ++result_.steps;
    const PartLook look = watch_.at(t_, true);
    result_.lower = t_;
    if (is_contact(look)) return end_contact(look);
    result_.upper = options_.to;
    if (!(look.lower > 0)) return look_ahead();
    if (t_ >= options_.to) {
      result_.outcome = ImpactResult::Outcome::free;
      return false;
    }
    if (speeds_.varies()) speeds_ = PairMotion(watch_, t_, end);
    const double safe = safe_until(watch_, look, speeds_, end);
    if (safe == kInfinity && end >= options_.to) {
      end_free();
      return false;
    }
    const double by_planes = watch_.is_convex() && safe < end ? planes_.next(look, speeds_, safe, end) : safe;
    const double next = safe >= end ? end : by_planes;
    if (!(next > t_)) return look_ahead();
    t_ = next;
    return true;
  }

  /// Where no step is proven any more, or steps have run out: the next moment of a proven contact, in steps
  /// that grow by a fifth. False: it is the end.
  bool look_ahead() {
    constexpr int kDoublings = 60, kLooksPerDoubling = 4;
    for (int k = kLooksPerDoubling * kDoublings; k >= 0 && t_ < options_.to; --k) {
      ++result_.steps;
      const double then =
          k == 0 ? options_.to
                 : t_ + (options_.to - t_) * std::exp2(-static_cast<double>(k) / kLooksPerDoubling);
      const PartLook look = watch_.at(then, true);
      if (is_contact(look)) return end_contact(look);
    }
    return false;
  }

  const ImpactResult& end_free() {
    result_.outcome = ImpactResult::Outcome::free;
    result_.lower = result_.upper = options_.to;
    return result_;
  }

  PartWatch watch_;
  PlaneSteps planes_;
  const ContinuousOptions& options_;
  ImpactResult result_;
  double t_;
  double piece_end_ = -kInfinity;
  PairMotion speeds_;  // over what is left of the piece
};

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

ImpactResult find_impact(PairSolver& solver, const Body& a, const Body& b, const ContinuousOptions& options) {
  if (a.parts.size() == 1 && b.parts.size() == 1) return Advance(solver, a, b, options).run();
  ImpactResult result;
  result.outcome = ImpactResult::Outcome::free;
  result.lower = result.upper = options.to;
  ContinuousOptions remaining = options;
  for (const PartPair& pair : part_pairs(a, b, options.from)) {
    ImpactResult one = Advance(solver, pair.a, pair.b, remaining).run();
    if (one.outcome == ImpactResult::Outcome::contact) pair.name_in(one.at_upper);
    take_sooner(result, one);
    if (result.outcome == ImpactResult::Outcome::contact) remaining.to = result.upper;
  }
  return result;
}

}  // namespace

ImpactResult time_of_impact(PairSolver& solver, const Body& a, const Body& b,
                            const ContinuousOptions& options) {
  solver.set_tolerance(PartWatch::kStepTolerance);
  const Riders riders(a, b, true);
  ImpactResult found = find_impact(solver, riders.a(), riders.b(), options);
  riders.to_scene(found.upper, found.at_upper);
  return found;
}

namespace {

void answer(const ContinuousQuestion& question, PairSolver& solver, SceneRecord& row) {
  const ImpactResult impact = time_of_impact(solver, question.a, question.b, question.options);
  row.time_lower = impact.lower;
  row.status = SceneStatus::undecided;
  if (impact.outcome == ImpactResult::Outcome::free) row.status = SceneStatus::free;
  if (impact.outcome != ImpactResult::Outcome::contact) return;
  row.status = SceneStatus::contact;
  row.time = row.time_upper = impact.upper;
  take_distance(impact.at_upper, row);
  take_points(impact.at_upper, row);
}

SceneEvent event(const SceneRecord& row, const std::string& /*unit*/) {
  SceneEvent event = event_of_kind(EventKind::undecided, row, row.time_lower);
  if (row.status == SceneStatus::free) {
    event = event_of_kind(EventKind::free, row, SceneRecord::kNone);
    event.text = "no contact, proven";
  } else if (row.status == SceneStatus::contact) {
    event = event_of_kind(EventKind::contact, row, row.time_upper);
    event.text = "first contact in " + event_interval(row.time_lower, row.time_upper);
  } else {
    event.text = "no contact before " + event_number(row.time_lower) + " s, proven; after that undecided";
  }
  return event;
}

}  // namespace

Effect time_of_impact_effect() noexcept {
  return {SceneEffects::time_of_impact, "time_of_impact",
          "time of impact: conservative advancement, from certified distance to certified distance", answer,
          event};
}

}  // namespace raygauge
