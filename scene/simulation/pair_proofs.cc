// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/queries/plane_steps.h"
#include "scene/simulation/pair_proofs.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-9;
constexpr double kUsual = 0.4, kMore = 0.45;  // of δ: of pairs that begin a step no deeper, and as they move
const SceneMetric kEuclidean;

// Without a contact up to there, or with one exactly there.
double free_until(const Body& a, const Body& b, double from, double to, double contact, PairTools& tools) {
  constexpr std::int64_t kMostSteps = 2000;
  if (!(from < to)) return from;
  ++tools.counters.motion_proofs;
  ContinuousOptions options;
  options.from = from;
  options.to = to;
  options.contact = contact;
  options.max_steps = kMostSteps;
  const ImpactResult found = tools.solver.time_of_impact(a, b, options);
  return found.outcome == ImpactResult::Outcome::free ? to : found.lower;
}

}  // namespace

// By planes across the normals at both ends and by those that turn from one to the other; by halves where
// that leaves much. Bounds of at least `enough` are not improved.
double PairProofs::least(const CandidatePair& candidate, const TimedLook& first, const TimedLook& last,
                         double enough, int halvings, PairTools& tools) const {
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  PartWatch watch(*tools.planes, a, b, kEuclidean, nullptr);
  const PairMotion motion(watch, first.time, last.time);
  const double length = last.time - first.time;
  const double way = (motion.a.speed(a.reach) + motion.b.speed(b.reach)) * length;
  if (std::max(first.contact.lower, last.contact.lower) > way * kOutward) return 0;
  const double least = std::min({0.0, first.contact.lower, last.contact.lower});
  const double aim = std::min(enough, least - std::max(scales_.delta / 4, -0.01 * least));
  PlaneSteps steps(watch);
  const SmallVector u = first.contact.normal.head(n_), w = last.contact.normal.head(n_);
  double bound = steps.least_along(u, first.time, last.time, motion);
  if (bound < aim) bound = std::max(bound, steps.least_along(w, last.time, first.time, motion));
  if (bound < aim) bound = std::max(bound, steps.least_turning(u, w, first.time, last.time, motion));
  if (bound >= aim || halvings == 0) return bound;
  const double middle = first.time + length / 2;
  const TimedLook between{middle, looks_.at(candidate, middle, scales_.delta + way, tools)};
  const double before = this->least(candidate, first, between, enough, halvings - 1, tools);
  const double after = this->least(candidate, between, last, std::min(enough, before), halvings - 1, tools);
  return std::max(bound, std::min(before, after));
}

// The time up to which the parts overlap by `most` at most, or a little less, by planes across the normal
// where they are, or across that at the end of what is looked at, or that turn from one to the other; halves
// of it where none proves it.
double PairProofs::overlap_until(const CandidatePair& candidate, const Eigen::Vector3d& normal, double from,
                                 double to, double most, PairTools& tools) const {
  constexpr int kMostLooks = 60;
  constexpr double kShortest = 1e-6;  // of the whole
  constexpr double kNear = 0.05;      // of what is proven: its end is looked for no closer
  ++tools.counters.motion_proofs;
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  PartWatch watch(*tools.planes, a, b, kEuclidean, nullptr);
  PlaneSteps steps(watch);
  SmallVector u = normal.head(n_);
  double proven = from, length = to - from;
  const auto is_long = [&] { return length > std::max(kShortest * (to - from), kNear * (proven - from)); };
  for (int k = 0; k < kMostLooks && proven < to && is_long(); ++k) {
    const double until = to - proven <= length * (1 + 1e-9) ? to : proven + length;
    const PairMotion motion(watch, proven, until);
    bool holds = steps.least_along(u, proven, until, motion) >= -most;
    if (!holds || until < to) {
      // Farther apart than the band no normal is found.
      const double band =
          scales_.delta + motion.a.speed(a.reach) * (until - from) + motion.b.speed(b.reach) * (until - from);
      const PartContact then = looks_.at(candidate, until, band, tools);
      const SmallVector other = then.normal.head(n_);
      holds =
          holds || (then.lower >= -most && (steps.least_along(other, until, proven, motion) >= -most ||
                                            steps.least_turning(u, other, proven, until, motion) >= -most));
      if (holds) u = other;
    }
    if (holds) proven = until;
    length *= holds ? 2 : 0.5;
  }
  return proven;
}

// How deep a pair that touches may come. The rest of δ is left for pairs that begin deeper than others end.
double PairProofs::most_overlap(const NearPair& pair) const {
  constexpr double kInside = 1 - 1e-9;
  return scales_.delta * (-pair.contact.lower < kUsual * scales_.delta ? kUsual + kMore : kInside);
}

double PairProofs::until(const CandidatePair& candidate, const NearPair* near, double t, double end,
                         PairTools& tools) const {
  // Of δ: how far bodies that leave each other are away when a new impact may come, which is past `arrival`.
  constexpr double kAway = 0.75;
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  if (near == nullptr) return free_until(a, b, t, end, scales_.arrival(), tools);
  const Eigen::Vector3d& normal = near->contact.normal;
  const double most = most_overlap(*near);
  if (near->role == PairRole::contact) return overlap_until(candidate, normal, t, end, most, tools);
  const double deep = std::max(0.0, -near->contact.lower);
  const double away = std::min(end, t + (kAway * scales_.delta + deep) / std::max(-near->closing, 1e-300));
  const double first = overlap_until(candidate, normal, t, away, most, tools);
  return first < away ? first : std::max(away, free_until(a, b, away, end, scales_.arrival(), tools));
}

}  // namespace raygauge
