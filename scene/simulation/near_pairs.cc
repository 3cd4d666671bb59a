// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raygauge/exceptions.h"
#include "scene/queries/plane_steps.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-9;
constexpr double kRounding = 1e-12;       // of what is added up
constexpr std::size_t kWorthWaking = 32;  // pairs, once a step

// To a few digits, so that the last bits of a step's length tell no band from another.
double rounded_up(double band) {
  int exponent = 0;
  const double mantissa = std::frexp(band, &exponent);
  return std::ldexp(std::ceil(mantissa * 16) / 16, exponent);
}

}  // namespace

NearPairs::NearPairs(const Scene& scene, const Dynamics& dynamics, const std::vector<SimulatedBody>& bodies,
                     std::vector<SimulatedPart>& parts, ContactScales scales, SimulationCounters& counters)
    : bodies_(bodies),
      parts_(parts),
      scales_(scales),
      counters_(counters),
      n_(scene.dimension()),
      sweep_(scene, dynamics, bodies, parts, counters),
      looks_(bodies, parts, scales, n_),
      proofs_(looks_, parts, scales, n_) {
  add_tools();
}

NearPairs::NearPairs(const NearPairs& all, const std::vector<SimulatedBody>& bodies,
                     std::vector<SimulatedPart>& parts, SimulationCounters& counters)
    : bodies_(bodies),
      parts_(parts),
      scales_(all.scales_),
      counters_(counters),
      n_(all.n_),
      sweep_(all.sweep_, bodies, parts, counters),
      looks_(bodies, parts, scales_, n_),
      proofs_(looks_, parts, scales_, n_) {
  add_tools();
}

NearPairs::~NearPairs() = default;

PairTools::PairTools(int dimension, double miss)
    : pose_a(dimension),
      pose_b(dimension),
      finder(miss),
      solver(dimension),
      planes(std::make_unique<PairSolver>(dimension)) {}

PairTools::~PairTools() = default;

void NearPairs::add_tools() { tools_.add(std::make_unique<PairTools>(n_, scales_.delta / 8)); }

void NearPairs::share_with(ChunkTeam& team, int threads) {
  team_ = &team;
  while (static_cast<int>(tools_.all().size()) < threads) add_tools();
}

void NearPairs::take_counters() {
  for (const auto& tools : tools_.all()) counters_ += std::exchange(tools->counters, SimulationCounters());
}

// Before its step, a body's motion is not known: its travel is that of its velocities.
std::vector<NearPair>& NearPairs::find(double t, double dt) {
  for (const NearPair& pair : near_) sweep_.find(pair.part_a, pair.part_b)->near = -1;
  std::swap(before_, near_);
  near_.clear();
  const std::vector<CandidatePair*>& met = sweep_.sweep(t, dt, scales_.delta);
  found_.resize(met.size());
  for_each(met.size(), [this, &met](std::size_t k, PairTools& tools) {
    const double band = rounded_up(2 * sweep_.travels(*met[k]) + scales_.delta);
    found_[k] = looks_.now(*met[k], band, band, tools);
  });
  for (std::size_t k = 0; k < met.size(); ++k) {
    if (found_[k] == nullptr || found_[k]->points.empty()) continue;
    CandidatePair& candidate = *met[k];
    candidate.normal = found_[k]->normal;
    candidate.near = static_cast<int>(near_.size());
    near_.push_back({candidate.part_a, candidate.part_b, part(candidate.part_a).owner,
                     part(candidate.part_b).owner, candidate.law, *found_[k], 0, PairRole::apart, 0});
  }
  for (const NearPair& pair : before_) {
    CandidatePair& candidate = *sweep_.find(pair.part_a, pair.part_b);
    if (candidate.near < 0) candidate.normal = Eigen::Vector3d::UnitX();
  }
  return near_;
}

void NearPairs::begin(const std::vector<int>& members, const std::vector<KnownNormal>& known) {
  sweep_.take(members);
  recall(known);
  for (const KnownNormal& one : known) {
    NearPair& pair = near_.emplace_back();
    pair.part_a = one.part_a;
    pair.part_b = one.part_b;
    pair.contact.normal = one.normal;
  }
}

std::vector<KnownNormal> NearPairs::end() {
  std::vector<KnownNormal> all;
  for (const NearPair& pair : near_) {
    all.push_back({pair.part_a, pair.part_b, pair.contact.normal});
    CandidatePair& candidate = *sweep_.find(pair.part_a, pair.part_b);
    candidate.normal = Eigen::Vector3d::UnitX();
    candidate.near = -1;
  }
  near_.clear();
  return all;
}

void NearPairs::recall(const std::vector<KnownNormal>& known) {
  for (const KnownNormal& one : known) {
    CandidatePair* const candidate = sweep_.find(one.part_a, one.part_b);
    if (candidate == nullptr) throw InvalidParameterError("simulation: a part is of another scene");
    candidate->normal = one.normal;
  }
}

void NearPairs::forget(const std::vector<KnownNormal>& known) {
  for (const KnownNormal& one : known) sweep_.find(one.part_a, one.part_b)->normal = Eigen::Vector3d::UnitX();
}

// Parts whose balls come near are looked at as the group's find() will, which then knows.
std::vector<std::pair<int, int>> NearPairs::meeting(double t, double dt, const std::vector<double>& ways) {
  sweep_.take_reacting(ways);
  std::vector<double> travels(parts_.size(), 0);
  for (const int i : sweep_.scope()) travels[static_cast<std::size_t>(i)] = sweep_.travel(i, t, dt);
  const std::vector<CandidatePair*>& all = sweep_.sweep(scales_.delta);
  const auto meets = [this](const CandidatePair& met) {
    return sweep_.travels(met) * kOutward + scales_.delta;
  };
  found_.resize(all.size());
  const auto look = [&](std::size_t k, PairTools& tools) {
    CandidatePair& met = *all[k];
    const double both =
        travels[static_cast<std::size_t>(met.part_a)] + travels[static_cast<std::size_t>(met.part_b)];
    const double band = rounded_up(2 * both + scales_.delta);
    found_[k] = looks_.now(met, band, std::max(band, meets(met)), tools);
  };
  for_each(all.size(), look, all.size() >= kWorthWaking);
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CandidatePair& met = *all[k];
    if (found_[k] == nullptr || found_[k]->lower > meets(met)) continue;
    pairs.emplace_back(part(met.part_a).owner, part(met.part_b).owner);
  }
  return pairs;
}

double NearPairs::distance_at(const NearPair& pair, double end, PairTools& tools) {
  return looks_.at(*sweep_.find(pair.part_a, pair.part_b), end, scales_.delta, tools).lower;
}

// Every pair is asked about the whole time, so that no answer depends on which was asked first.
double NearPairs::proven_until(double t, double end) {
  hand_motions();
  nothing_touched_ = true;
  ended_proof_ = nullptr;
  in_doubt_.clear();
  for (CandidatePair* const candidate : sweep_.sweep(t, end - t, scales_.arrival())) {
    nothing_touched_ = nothing_touched_ && touching(*candidate) == nullptr;
    if (!is_known_proven(*candidate)) in_doubt_.push_back(candidate);
  }
  proven_.resize(in_doubt_.size());
  for_each(in_doubt_.size(), [this, t, end](std::size_t k, PairTools& tools) {
    proven_[k] = proofs_.until(*in_doubt_[k], touching(*in_doubt_[k]), t, end, tools);
  });
  double proven = end;
  for (std::size_t k = 0; k < in_doubt_.size(); ++k) {
    if (!(proven_[k] < proven)) continue;
    proven = proven_[k];
    const int near = in_doubt_[k]->near;
    ended_proof_ = near < 0 ? nullptr : &near_[static_cast<std::size_t>(near)];
  }
  return proven;
}

double NearPairs::least_distance(double t, double end) {
  constexpr int kMostHalvings = 12;
  hand_motions();
  double least = 0;
  PairTools& tools = *tools_.all().front();
  for (const CandidatePair* const met : sweep_.sweep(t, end - t, 0)) {
    ++tools.counters.motion_proofs;
    const double band = scales_.delta + sweep_.travels(*met);
    const PairProofs::TimedLook first{t, looks_.at(*met, t, band, tools)};
    const PairProofs::TimedLook last{end, looks_.at(*met, end, band, tools)};
    least = std::min(least, proofs_.least(*met, first, last, least, kMostHalvings, tools));
  }
  take_counters();
  return least;
}

const NearPair* NearPairs::touching(const CandidatePair& candidate) const {
  if (candidate.near < 0) return nullptr;
  const NearPair& pair = near_[static_cast<std::size_t>(candidate.near)];
  return pair.role == PairRole::apart ? nullptr : &pair;
}

// Without any work: they lie still, or were so far apart before this substep, as was just found, that their
// ways do not lead to `arrival`.
bool NearPairs::is_known_proven(const CandidatePair& candidate) const {
  if (const NearPair* const near = touching(candidate))
    return looks_.stays(candidate, -proofs_.most_overlap(*near));
  const double rounding =
      kRounding * (sweep_.of(candidate.part_a).middle.norm() + sweep_.of(candidate.part_b).middle.norm());
  const double reached = (sweep_.travels(candidate) + scales_.arrival() + rounding) * kOutward;
  return looks_.is_known_apart(candidate, reached) || looks_.stays(candidate, scales_.arrival());
}

void NearPairs::hand_motions() {
  for (const int i : sweep_.scope()) {
    SimulatedPart& part = parts_[static_cast<std::size_t>(i)];
    part.body.motion = bodies_[static_cast<std::size_t>(part.owner)].motion;
  }
}

}  // namespace raygauge
