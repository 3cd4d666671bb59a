// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// How a simulation begins: with bodies that do not overlap.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "scene/simulation/simulator.h"

namespace raygauge {
namespace {

constexpr int kMostRounds = 100;     // a pile of a hundred boxes takes ten
constexpr int kMostSweeps = 10'000;  // a stack of twenty takes a thousand

// Of a pair that may overlap: how far its bodies are to move apart along its normal.
struct Push {
  std::size_t a, b;
  Eigen::Vector3d normal;
  double depth;
  double give;  // of both bodies
  double by = 0;
};

// The least translations, weighted by masses, after which no pair overlaps, to first order: projected
// Gauss-Seidel, to `error`.
std::vector<Eigen::Vector3d> translations(std::vector<Push>& pushes, const std::vector<SimulatedBody>& bodies,
                                          double error) {
  std::vector<Eigen::Vector3d> moved(bodies.size(), Eigen::Vector3d::Zero());
  double change = error;
  for (int sweep = 0; sweep < kMostSweeps && change >= error; ++sweep) {
    change = 0;
    for (Push& push : pushes) {
      const double left = push.depth - push.normal.dot(moved[push.a] - moved[push.b]);
      const double more = std::max(-push.by, left / push.give);
      push.by += more;
      moved[push.a] += bodies[push.a].inverse_mass * more * push.normal;
      moved[push.b] -= bodies[push.b].inverse_mass * more * push.normal;
      change = std::max(change, std::fabs(more) * push.give);
    }
  }
  return moved;
}

}  // namespace

void Simulator::come_to_start() {
  for (SimulatedBody& body : bodies_) {
    if (body.reacts()) continue;
    const Placement at = body.motion->at(t_);
    body.x = in_space(at.t);
    body.R = in_space(at.R);
  }
  const bool resolves = dynamics_.overlap_at_start == StartOverlap::resolved;
  if (resolves && hooks_.advance)
    throw InvalidParameterError(
        "dynamics: overlap_at_start = \"resolve\" is for raygauge's own steps, not for other engines");
  if (resolves) resolve_overlaps();
  refuse_overlaps();
  normals_ = pairs_->end();
}

// Normals and depths change with the translations: again, until no pair overlaps.
void Simulator::resolve_overlaps() {
  std::vector<Eigen::Vector3d> start;
  for (const SimulatedBody& body : bodies_) start.push_back(body.x);
  bool overlap = true;
  for (int round = 0; round < kMostRounds && overlap; ++round) {
    overlap = false;
    std::vector<Push> pushes;
    for (const NearPair& pair : pairs_->find(t_, 0)) {
      const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
      overlap |= -pair.contact.lower > scales_.delta / 2;
      pushes.push_back({a, b, pair.contact.normal, -pair.contact.lower,
                        bodies_[a].inverse_mass + bodies_[b].inverse_mass});
    }
    if (!overlap) break;
    const std::vector<Eigen::Vector3d> moved = translations(pushes, bodies_, scales_.delta / 100);
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].x += moved[i];
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    out_.moved_at_start = std::max(out_.moved_at_start, (bodies_[i].x - start[i]).norm());
}

void Simulator::refuse_overlaps() {
  for (const NearPair& pair : pairs_->find(t_, 0)) {
    if (!(pair.contact.overlap > scales_.delta)) continue;
    const auto name = [this](int body) {
      return "'" + out_.scene.bodies[static_cast<std::size_t>(body)].name + "'";
    };
    const bool tried = dynamics_.overlap_at_start == StartOverlap::resolved;
    throw InvalidParameterError(
        "dynamics: bodies " + name(pair.a) + " and " + name(pair.b) + " overlap at the start, by " +
        std::to_string(pair.contact.overlap) + " at least" +
        (tried ? ", and cannot be moved apart" : "; overlap_at_start = \"resolve\" moves bodies apart"));
  }
}

}  // namespace raygauge
