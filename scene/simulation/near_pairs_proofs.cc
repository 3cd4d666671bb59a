// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/queries/plane_steps.h"
#include "scene/simulation/near_pairs.h"

// What is proven of pairs over a substep.
namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-9;
constexpr double kUsual = 0.4, kMore = 0.45;  // of δ: of pairs that begin a step no deeper, and as they move
const SceneMetric kEuclidean;

}  // namespace

double NearPairs::proven_until(double t, double end) {
  hand_motions();
  nothing_touched_ = true;
  double proven = end;
  sweep(t, end - t, scales_.arrival());
  for (const Candidate* const candidate : may_meet_) {
    const double until = proven_pair(*candidate, t, proven);
    if (!(until < proven)) continue;
    proven = until;
    contact_ended_proof_ =
        candidate->near >= 0 && near_[static_cast<std::size_t>(candidate->near)].role == PairRole::contact;
    if (!(proven > t)) break;
  }
  return proven;
}

double NearPairs::least_distance(double t, double end) {
  constexpr int kMostHalvings = 12;
  hand_motions();
  sweep(t, end - t, 0);
  double least = 0;
  for (const Candidate* const met : may_meet_) {
    ++counters_.motion_proofs;
    const double band = scales_.delta + swept_[static_cast<std::size_t>(met->part_a)].travel +
                        swept_[static_cast<std::size_t>(met->part_b)].travel;
    const TimedLook first{t, look_at(*met, t, band)}, last{end, look_at(*met, end, band)};
    least = std::min(least, least_of(*met, first, last, least, kMostHalvings));
  }
  return least;
}

PartContact NearPairs::look_at(const Candidate& candidate, double t, double band) {
  PartContact contact;
  look(candidate, part(candidate.part_a).body.motion->at(t), part(candidate.part_b).body.motion->at(t), band,
       contact);
  return contact;
}

// By planes across the normals at both ends and by those that turn from one to the other; by halves where
// that leaves much. Bounds of at least `enough` are not improved.
double NearPairs::least_of(const Candidate& candidate, const TimedLook& first, const TimedLook& last,
                           double enough, int halvings) {
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  PartWatch watch(*planes_, a, b, kEuclidean, nullptr);
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
  const TimedLook between{middle, look_at(candidate, middle, scales_.delta + way)};
  const double before = least_of(candidate, first, between, enough, halvings - 1);
  const double after = least_of(candidate, between, last, std::min(enough, before), halvings - 1);
  return std::max(bound, std::min(before, after));
}

// Without a contact up to there, or with one exactly there.
double NearPairs::free_until(const Body& a, const Body& b, double from, double to, double contact) {
  constexpr std::int64_t kMostSteps = 2000;
  if (!(from < to)) return from;
  ++counters_.motion_proofs;
  ContinuousOptions options;
  options.from = from;
  options.to = to;
  options.contact = contact;
  options.max_steps = kMostSteps;
  const ImpactResult found = solver_.time_of_impact(a, b, options);
  return found.outcome == ImpactResult::Outcome::free ? to : found.lower;
}

// The time up to which the parts overlap by `most` at most, or a little less, by planes across the normal
// where they are, or across that at the end of what is looked at, or that turn from one to the other; halves
// of it where none proves it.
double NearPairs::overlap_until(const Candidate& candidate, const Eigen::Vector3d& normal, double from,
                                double to, double most) {
  constexpr int kMostLooks = 60;
  constexpr double kShortest = 1e-6;  // of the whole
  constexpr double kNear = 0.05;      // of what is proven: its end is looked for no closer
  ++counters_.motion_proofs;
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  PartWatch watch(*planes_, a, b, kEuclidean, nullptr);
  PlaneSteps steps(watch);
  SmallVector u = normal.head(n_);
  double proven = from, length = to - from;
  const auto is_long = [&] { return length > std::max(kShortest * (to - from), kNear * (proven - from)); };
  for (int k = 0; k < kMostLooks && proven < to && is_long(); ++k) {
    const double until = to - proven <= length * (1 + 1e-9) ? to : proven + length;
    const PairMotion motion(watch, proven, until);
    bool holds = steps.least_along(u, proven, until, motion) >= -most;
    if (!holds || until < to) {
      PartContact then;
      // Farther apart than the band no normal is found.
      const double band =
          scales_.delta + motion.a.speed(a.reach) * (until - from) + motion.b.speed(b.reach) * (until - from);
      look(candidate, a.motion->at(until), b.motion->at(until), band, then);
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

double NearPairs::proven_pair(const Candidate& candidate, double t, double end) {
  // Of δ: how far bodies that leave each other are away when a new impact may come, which is past `arrival`.
  constexpr double kAway = 0.75;
  constexpr double kInside = 1 - 1e-9;
  const NearPair* near = candidate.near < 0 ? nullptr : &near_[static_cast<std::size_t>(candidate.near)];
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  if (near == nullptr || near->role == PairRole::apart) {
    const bool away = stays_away(candidate) || stays(candidate, scales_.arrival());
    return away ? end : free_until(a, b, t, end, scales_.arrival());
  }
  nothing_touched_ = false;
  const Eigen::Vector3d& normal = near->contact.normal;
  const double deep = std::max(0.0, -near->contact.lower);
  // The rest of δ is left for pairs that begin deeper than others end.
  const double most = scales_.delta * (deep < kUsual * scales_.delta ? kUsual + kMore : kInside);
  if (stays(candidate, -most)) return end;
  if (near->role == PairRole::contact) return overlap_until(candidate, normal, t, end, most);
  const double away = std::min(end, t + (kAway * scales_.delta + deep) / std::max(-near->closing, 1e-300));
  const double first = overlap_until(candidate, normal, t, away, most);
  return first < away ? first : std::max(away, free_until(a, b, away, end, scales_.arrival()));
}

}  // namespace raygauge
