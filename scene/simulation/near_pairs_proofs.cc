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

// Every pair is asked about the whole time, so that no answer depends on which was asked first.
double NearPairs::proven_until(double t, double end) {
  hand_motions();
  nothing_touched_ = true;
  sweep(t, end - t, scales_.arrival());
  in_doubt_.clear();
  for (Candidate* const candidate : may_meet_) {
    nothing_touched_ = nothing_touched_ && is_apart(*candidate);
    if (!is_known_proven(*candidate)) in_doubt_.push_back(candidate);
  }
  proven_.resize(in_doubt_.size());
  for_each(in_doubt_.size(), [this, t, end](std::size_t k, PairTools& tools) {
    proven_[k] = proven_pair(*in_doubt_[k], t, end, tools);
  });
  double proven = end;
  for (std::size_t k = 0; k < in_doubt_.size(); ++k) {
    if (!(proven_[k] < proven)) continue;
    proven = proven_[k];
    const int near = in_doubt_[k]->near;
    contact_ended_proof_ = near >= 0 && near_[static_cast<std::size_t>(near)].role == PairRole::contact;
  }
  return proven;
}

double NearPairs::least_distance(double t, double end) {
  constexpr int kMostHalvings = 12;
  hand_motions();
  sweep(t, end - t, 0);
  double least = 0;
  PairTools& tools = *tools_.all().front();
  for (const Candidate* const met : may_meet_) {
    ++tools.counters.motion_proofs;
    const double band = scales_.delta + swept_[static_cast<std::size_t>(met->part_a)].travel +
                        swept_[static_cast<std::size_t>(met->part_b)].travel;
    const TimedLook first{t, look_at(*met, t, band, tools)}, last{end, look_at(*met, end, band, tools)};
    least = std::min(least, least_of(*met, first, last, least, kMostHalvings, tools));
  }
  take_counters();
  return least;
}

PartContact NearPairs::look_at(const Candidate& candidate, double t, double band, PairTools& tools) {
  PartContact contact;
  look(candidate, part(candidate.part_a).body.motion->at(t), part(candidate.part_b).body.motion->at(t), band,
       contact, tools);
  return contact;
}

// By planes across the normals at both ends and by those that turn from one to the other; by halves where
// that leaves much. Bounds of at least `enough` are not improved.
double NearPairs::least_of(const Candidate& candidate, const TimedLook& first, const TimedLook& last,
                           double enough, int halvings, PairTools& tools) {
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
  const TimedLook between{middle, look_at(candidate, middle, scales_.delta + way, tools)};
  const double before = least_of(candidate, first, between, enough, halvings - 1, tools);
  const double after = least_of(candidate, between, last, std::min(enough, before), halvings - 1, tools);
  return std::max(bound, std::min(before, after));
}

// Without a contact up to there, or with one exactly there.
double NearPairs::free_until(const Body& a, const Body& b, double from, double to, double contact,
                             PairTools& tools) {
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

// The time up to which the parts overlap by `most` at most, or a little less, by planes across the normal
// where they are, or across that at the end of what is looked at, or that turn from one to the other; halves
// of it where none proves it.
double NearPairs::overlap_until(const Candidate& candidate, const Eigen::Vector3d& normal, double from,
                                double to, double most, PairTools& tools) {
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
      PartContact then;
      // Farther apart than the band no normal is found.
      const double band =
          scales_.delta + motion.a.speed(a.reach) * (until - from) + motion.b.speed(b.reach) * (until - from);
      look(candidate, a.motion->at(until), b.motion->at(until), band, then, tools);
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

bool NearPairs::is_apart(const Candidate& candidate) const {
  return candidate.near < 0 || near_[static_cast<std::size_t>(candidate.near)].role == PairRole::apart;
}

// How deep a pair that touches may come. The rest of δ is left for pairs that begin deeper than others end.
double NearPairs::most_overlap(const NearPair& pair) const {
  constexpr double kInside = 1 - 1e-9;
  return scales_.delta * (-pair.contact.lower < kUsual * scales_.delta ? kUsual + kMore : kInside);
}

// Without any work.
bool NearPairs::is_known_proven(const Candidate& candidate) const {
  if (is_apart(candidate)) return stays_away(candidate) || stays(candidate, scales_.arrival());
  return stays(candidate, -most_overlap(near_[static_cast<std::size_t>(candidate.near)]));
}

double NearPairs::proven_pair(const Candidate& candidate, double t, double end, PairTools& tools) {
  // Of δ: how far bodies that leave each other are away when a new impact may come, which is past `arrival`.
  constexpr double kAway = 0.75;
  const Body &a = part(candidate.part_a).body, &b = part(candidate.part_b).body;
  if (is_apart(candidate)) return free_until(a, b, t, end, scales_.arrival(), tools);
  const NearPair& near = near_[static_cast<std::size_t>(candidate.near)];
  const Eigen::Vector3d& normal = near.contact.normal;
  const double most = most_overlap(near);
  if (near.role == PairRole::contact) return overlap_until(candidate, normal, t, end, most, tools);
  const double deep = std::max(0.0, -near.contact.lower);
  const double away = std::min(end, t + (kAway * scales_.delta + deep) / std::max(-near.closing, 1e-300));
  const double first = overlap_until(candidate, normal, t, away, most, tools);
  return first < away ? first : std::max(away, free_until(a, b, away, end, scales_.arrival(), tools));
}

}  // namespace raygauge
