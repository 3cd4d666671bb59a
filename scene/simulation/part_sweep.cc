// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/part_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "raygauge/sets/half_space.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Around a part of a body that stands, by support points: closer than around the ball, of a wall or a floor.
std::optional<Eigen::AlignedBox3d> standing_box(const SimulatedPart& part, const SimulatedBody& owner) {
  const ConvexSet& S = *part.body.parts.front().set;
  if (owner.reacts() || !owner.motion->is_static() || as_half_space(S) != nullptr) return std::nullopt;
  const int n = S.dimension();
  const Placement at = owner.motion->at(0);
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  Eigen::VectorXd point(n);
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd axis = at.R.row(k).transpose(), back = -axis;
    high[k] = at.t[k] + S.support_unchecked(axis.data(), point.data());
    low[k] = at.t[k] - S.support_unchecked(back.data(), point.data());
  }
  return Eigen::AlignedBox3d(low, high);
}

}  // namespace

PartSweep::PartSweep(const Scene& scene, const Dynamics& dynamics, const std::vector<SimulatedBody>& bodies,
                     const std::vector<SimulatedPart>& parts, SimulationCounters& counters)
    : dynamics_(dynamics),
      bodies_(bodies),
      parts_(parts),
      counters_(counters),
      n_(scene.dimension()),
      candidates_(std::make_shared<std::vector<CandidatePair>>()),
      parts_of_(bodies.size()),
      scope_(parts.size()) {
  std::iota(scope_.begin(), scope_.end(), 0);
  std::set<BodyPair> ignored;
  for (const auto& [a, b] : scene.ignored) ignored.insert({std::min(a, b), std::max(a, b)});
  for (const int i : scope_) parts_of_[static_cast<std::size_t>(part(i).owner)].push_back(i);
  for (const SimulatedPart& part : parts)
    standing_.push_back(standing_box(part, bodies[static_cast<std::size_t>(part.owner)]));
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(parts.size()); ++j) {
      const int a = parts[static_cast<std::size_t>(i)].owner, b = parts[static_cast<std::size_t>(j)].owner;
      const bool reacts =
          bodies[static_cast<std::size_t>(a)].reacts() || bodies[static_cast<std::size_t>(b)].reacts();
      if (a == b || !reacts || ignored.count({std::min(a, b), std::max(a, b)}) != 0) continue;
      if (const auto law = dynamics.law_of(a, b))
        candidates_->push_back({i, j, *law, Eigen::Vector3d::UnitX(), -1, nullptr});
    }
  }
  number_candidates();
}

PartSweep::PartSweep(const PartSweep& all, const std::vector<SimulatedBody>& bodies,
                     const std::vector<SimulatedPart>& parts, SimulationCounters& counters)
    : dynamics_(all.dynamics_),
      bodies_(bodies),
      parts_(parts),
      counters_(counters),
      n_(all.n_),
      candidates_(all.candidates_),
      first_candidates_(all.first_candidates_),
      parts_of_(all.parts_of_),
      scope_(all.scope_),
      standing_(all.standing_) {}

void PartSweep::take(const std::vector<int>& members) {
  scope_.clear();
  for (const int b : members) {
    const std::vector<int>& own = parts_of_[static_cast<std::size_t>(b)];
    scope_.insert(scope_.end(), own.begin(), own.end());
  }
  std::sort(scope_.begin(), scope_.end());
}

void PartSweep::take_reacting(const std::vector<double>& ways) {
  scope_.clear();
  swept_.resize(parts_.size());
  for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
    const auto owner = static_cast<std::size_t>(part(i).owner);
    if (!bodies_[owner].reacts()) continue;
    scope_.push_back(i);
    swept_[static_cast<std::size_t>(i)].travel = ways[owner];
  }
}

// Of the ball around a part.
Eigen::Vector3d PartSweep::middle(int number) const {
  const SimulatedPart& p = part(number);
  const SimulatedBody& body = bodies_[static_cast<std::size_t>(p.owner)];
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  c.head(n_) = p.body.ball.center;
  return body.x + body.R * c;
}

// No point of a part moves farther within dt, as its body moves.
double PartSweep::travel(int number, double t, double dt) const {
  const SimulatedPart& p = part(number);
  const SimulatedBody& body = bodies_[static_cast<std::size_t>(p.owner)];
  if (body.motion != nullptr) return body.motion->bound(t, t + dt).speed(p.body.reach) * dt;
  const double g = dynamics_.gravity ? dynamics_.gravity->norm() : 0.0;
  return (body.v.norm() + g * dt + body.spin.norm() * p.body.reach) * dt;
}

void PartSweep::number_candidates() {
  first_candidates_.assign(parts_.size() + 1, candidates_->size());
  for (std::size_t k = candidates_->size(); k-- > 0;)
    first_candidates_[static_cast<std::size_t>((*candidates_)[k].part_a)] = k;
  for (std::size_t i = parts_.size(); i-- > 0;)
    first_candidates_[i] = std::min(first_candidates_[i], first_candidates_[i + 1]);
}

// At the place that it has where every part after the first makes a candidate with it, or before.
CandidatePair* PartSweep::find(int part_a, int part_b) {
  const auto [first, second] = std::minmax(part_a, part_b);
  const auto row = candidates_->begin();
  const auto begin = row + static_cast<std::ptrdiff_t>(first_candidates_[static_cast<std::size_t>(first)]);
  const auto end = row + static_cast<std::ptrdiff_t>(first_candidates_[static_cast<std::size_t>(first) + 1]);
  const std::ptrdiff_t place = second - first - 1;
  if (place < end - begin && begin[place].part_b == second) return &begin[place];
  const auto found = std::lower_bound(
      begin, end, second, [](const CandidatePair& one, int wanted) { return one.part_b < wanted; });
  return found != end && found->part_b == second ? &*found : nullptr;
}

const std::vector<CandidatePair*>& PartSweep::sweep(double t, double dt, double beyond) {
  swept_.resize(parts_.size());
  for (const int i : scope_) swept_[static_cast<std::size_t>(i)].travel = travel(i, t, dt);
  return sweep(beyond);
}

// Which candidates may come closer than `beyond` within their travels: of parts whose boxes meet, in the
// order of candidates_.
const std::vector<CandidatePair*>& PartSweep::sweep(double beyond) {
  may_meet_.clear();
  if (candidates_->empty()) return may_meet_;
  boxes_.clear();
  for (const int i : scope_) {
    Swept& one = swept_[static_cast<std::size_t>(i)];
    one.middle = middle(i);
    one.radius = part(i).body.ball.radius;
    const auto& standing = standing_[static_cast<std::size_t>(i)];
    const double radius = standing ? 0 : one.radius;
    // With more than the rounding that may_meet() allows for.
    const double size = one.middle.norm() + one.radius;
    const double reach = (radius + one.travel + beyond + 1e-11 * size) * kOutward;
    const bool bounded = std::isfinite(reach);
    const Eigen::AlignedBox3d box = standing ? *standing : Eigen::AlignedBox3d(one.middle);
    boxes_.push_back(
        {bounded ? Eigen::Vector3d(box.min().array() - reach) : Eigen::Vector3d::Constant(-kInfinity),
         bounded ? Eigen::Vector3d(box.max().array() + reach) : Eigen::Vector3d::Constant(kInfinity), i});
  }
  std::sort(boxes_.begin(), boxes_.end(), [](const SweptBox& one, const SweptBox& other) {
    return std::pair(one.low[0], one.part) < std::pair(other.low[0], other.part);
  });
  for (auto one = boxes_.begin(); one != boxes_.end(); ++one) {
    for (auto other = one + 1; other != boxes_.end() && other->low[0] <= one->high[0]; ++other) {
      if (other->low[1] > one->high[1] || one->low[1] > other->high[1]) continue;
      if (other->low[2] > one->high[2] || one->low[2] > other->high[2]) continue;
      if (!may_meet(one->part, other->part, beyond)) continue;
      if (CandidatePair* candidate = find(one->part, other->part)) may_meet_.push_back(candidate);
    }
  }
  std::sort(may_meet_.begin(), may_meet_.end());
  return may_meet_;
}

bool PartSweep::may_meet(int a, int b, double beyond) {
  ++counters_.ball_tests;
  const Swept &one = of(a), &other = of(b);
  const double reached = one.radius + other.radius + one.travel + other.travel + beyond;
  const double rounding = 1e-12 * (one.middle.norm() + other.middle.norm());
  return !((one.middle - other.middle).norm() > (reached + rounding) * kOutward);
}

}  // namespace raygauge
