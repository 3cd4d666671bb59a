// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/scene/part_watch.h"

namespace raygauge {
namespace {

const SceneMetric kEuclidean;
constexpr double kOutward = 1 + 1e-12;  // of a few operations

// How both bodies move over [from, to], a time within a piece of either motion.
struct Speeds {
  MotionBound a, b;

  Speeds(const PartWatch& watch, double from, double to)
      : a(watch.a().motion->bound(from, to)), b(watch.b().motion->bound(from, to)) {}

  /// Whether bounds over less time may be better.
  bool vary() const { return a.velocity_error + a.spin_error + b.velocity_error + b.spin_error > 0; }
};

// The time until which `look` proves that there is no contact; beyond `end` where it is past it.
double safe_until(const PartWatch& watch, const PartLook& look, const Speeds& speeds, double end) {
  const double t = look.time;
  const auto reached = [&](const Speeds& over, double ahead) {
    const double speed = over.b.speed_along(look.normal, watch.b().reach) +
                         over.a.speed_along(SmallVector(-look.normal), watch.a().reach);
    if (speed <= 0) return ahead == end ? kInfinity : ahead;
    const double next = t + look.lower / speed * (1 - 1e-13);
    return next > ahead ? (ahead == end ? kInfinity : ahead) : std::nextafter(next, t);
  };
  const double whole = reached(speeds, end);
  const double ahead = t + 4 * (std::min(whole, end) - t);
  if (!speeds.vary() || whole >= end || ahead >= end) return whole;
  return std::max(whole, reached(Speeds(watch, t, ahead), ahead));
}

// What the height of a body over a plane may have between two moments above its linear interpolation: at most
// curvature T² + drift T over a time T.
struct Bulge {
  double curvature = 0, drift = 0;
  double over(double T) const { return (curvature * T + drift) * T * kOutward; }
};

// Seen from the body the unit vector u turns, w' = w × spin, and the height is h(w), convex and at most
// reach |w|: its excess over the chord is reach times that of w, |w''| T²/8 with |w''| = |spin| |spin × u|.
// An angular velocity that differs from the spin by e adds 2 e T reach at most, a velocity e T/2.
void add_bulge(const MotionBound& bound, double reach, const SmallVector& u, Bulge& bulge) {
  bulge.curvature += bound.turning(u) * bound.spin.norm() * reach / 8;
  bulge.drift += bound.velocity_error / 2 + 2 * bound.spin_error * reach;
}

Bulge bulge_of(const PartWatch& watch, const SmallVector& u, const Speeds& speeds) {
  Bulge bulge;
  add_bulge(speeds.a, watch.a().reach, u, bulge);
  add_bulge(speeds.b, watch.b().reach, u, bulge);
  return bulge;
}

// As safe_until, but farther: two planes across the normal of the look, which touch the bodies, are apart at
// both ends of a time by more than the bodies may bulge in between. The first time tried is where the speeds
// of the touching points lead to, less what the turning of the bodies may take; after that, where the line
// through both ends does.
// `apart_then`: how far apart they are then.
double planes_until(PartWatch& watch, const PartLook& look, const Speeds& speeds, double safe, double end,
                    double& apart_then) {
  constexpr int kTrials = 3;
  const double t = look.time;
  const SmallVector u = look.normal / look.normal.norm();
  SmallVector arm_a, arm_b;
  const double apart = std::min(look.lower, watch.apart_along(t, u, arm_a, arm_b));
  const double speed = speeds.b.velocity_of(arm_b).dot(u) - speeds.a.velocity_of(arm_a).dot(u);
  Bulge bulge = bulge_of(watch, u, speeds);
  const double v = speed + bulge.drift, root = std::sqrt(v * v + 32 * bulge.curvature * apart);
  double time = v + root > 0 ? std::min(end - t, 2 * apart / (v + root)) : end - t;
  for (int trial = 0; trial < kTrials && t + time > safe; ++trial) {
    const double until = std::min(t + time, end);
    if (speeds.vary()) bulge = bulge_of(watch, u, Speeds(watch, t, until));
    const double then = watch.apart_along(until, u, arm_a, arm_b), over = bulge.over(until - t);
    if (std::min(apart, then) > over) {
      apart_then = then;
      return until;
    }
    time *= std::clamp((apart - 3 * over) / (apart - then), 0.25, 0.9);
  }
  return safe;
}

ImpactResult advance(PairSolver& solver, const Body& a, const Body& b, const ContinuousOptions& options) {
  PartWatch watch(solver, a, b, kEuclidean, nullptr);
  ImpactResult result;
  result.lower = result.upper = options.from;
  double t = options.from, apart = kInfinity;
  while (result.steps < options.max_steps) {
    ++result.steps;
    const bool touching = apart <= options.contact;  // most likely
    const PartLook look = watch.at(t, touching);
    result.lower = t;
    if (look.answer.intersecting() || look.upper <= options.contact) {
      result.outcome = ImpactResult::Outcome::contact;
      result.upper = t;
      result.at_upper = touching ? look.answer : watch.at(t, true).answer;
      return result;
    }
    result.upper = options.to;
    if (t >= options.to && look.lower > 0) {
      result.outcome = ImpactResult::Outcome::free;
      return result;
    }
    if (!(look.lower > 0)) return result;
    const double end = watch.end_of_piece(t, options.to);
    const Speeds speeds(watch, t, end);
    const double safe = safe_until(watch, look, speeds, end);
    if (safe == kInfinity && end >= options.to) {
      result.outcome = ImpactResult::Outcome::free;
      result.lower = options.to;
      return result;
    }
    apart = kInfinity;
    const double next = safe < end ? planes_until(watch, look, speeds, safe, end, apart) : end;
    if (!(next > t)) return result;
    t = next;
  }
  return result;
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
  solver.set_tolerance(PartWatch::kStepTolerance);
  if (a.parts.size() == 1 && b.parts.size() == 1) return advance(solver, a, b, options);
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

}  // namespace raygauge
