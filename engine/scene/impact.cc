// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/scene/plane_steps.h"

namespace raygauge {
namespace {

const SceneMetric kEuclidean;

// The time until which `look` proves that there is no contact; beyond `end` where it is past it.
double safe_until(const PartWatch& watch, const PartLook& look, const PairMotion& speeds, double end) {
  const double t = look.time;
  const auto reached = [&](const PairMotion& over, double ahead) {
    const double speed = over.b.speed_along(look.normal, watch.b().core_reach) +
                         over.a.speed_along(SmallVector(-look.normal), watch.a().core_reach);
    if (speed <= 0) return ahead == end ? kInfinity : ahead;
    const double next = t + look.lower / speed * (1 - 1e-13);
    return next > ahead ? (ahead == end ? kInfinity : ahead) : std::nextafter(next, t);
  };
  const double whole = reached(speeds, end);
  const double ahead = t + 4 * (std::min(whole, end) - t);
  if (!speeds.varies() || whole >= end || ahead >= end) return whole;
  return std::max(whole, reached(PairMotion(watch, t, ahead), ahead));
}

ImpactResult advance(PairSolver& solver, const Body& a, const Body& b, const ContinuousOptions& options) {
  PartWatch watch(solver, a, b, kEuclidean, nullptr);
  PlaneSteps planes(watch);
  ImpactResult result;
  result.lower = result.upper = options.from;
  double t = options.from;
  double piece_end = -kInfinity;
  PairMotion speeds(watch, t, t);
  while (result.steps < options.max_steps) {
    ++result.steps;
    const PartLook look = watch.at(t, true);
    result.lower = t;
    if (look.answer.intersecting() || look.upper <= options.contact) {
      result.outcome = ImpactResult::Outcome::contact;
      result.upper = t;
      result.at_upper = look.answer;
      return result;
    }
    result.upper = options.to;
    if (t >= options.to && look.lower > 0) {
      result.outcome = ImpactResult::Outcome::free;
      return result;
    }
    if (!(look.lower > 0)) return result;
    const double end = watch.end_of_piece(t, options.to);
    if (end != piece_end || speeds.varies()) speeds = PairMotion(watch, t, end);
    piece_end = end;
    const double safe = safe_until(watch, look, speeds, end);
    if (safe == kInfinity && end >= options.to) {
      result.outcome = ImpactResult::Outcome::free;
      result.lower = options.to;
      return result;
    }
    const double next = safe < end ? planes.next(look, speeds, safe, end) : end;
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
