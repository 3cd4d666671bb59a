// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// How a simulation begins: with bodies that do not overlap.
#include <algorithm>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "scene/simulation/simulator.h"

namespace raygauge {
namespace {

// A stack of ten takes a hundred; bodies that are wedged in never come apart.
constexpr int kMostPushes = 2000;

}  // namespace

void Simulator::come_to_start() {
  follow_motions();
  const bool resolves = dynamics_.overlap_at_start == StartOverlap::resolved;
  if (resolves && hooks_.advance)
    throw InvalidParameterError(
        "dynamics: overlap_at_start = \"resolve\" is for raygauge's own steps, not for other engines");
  if (resolves) resolve_overlaps();
  refuse_overlaps();
}

// All pairs that overlap are pushed apart along their normals, by the depth that is left of what others of
// the same round have done to them, lighter bodies farther; again until none overlaps.
void Simulator::resolve_overlaps() {
  std::vector<Eigen::Vector3d> start, pushed;
  for (const SimulatedBody& body : bodies_) start.push_back(body.x);
  for (int round = 0; round < kMostPushes && !stop_now(); ++round) {
    pushed.assign(bodies_.size(), Eigen::Vector3d::Zero());
    bool any = false;
    for (const NearPair& pair : pairs_->find(t_, 0)) {
      const double depth = -pair.contact.lower;
      if (!(depth > scales_.delta / 2)) continue;
      any = true;
      const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
      const double left = depth - pair.contact.normal.dot(pushed[a] - pushed[b]);
      const double give = bodies_[a].inverse_mass + bodies_[b].inverse_mass;
      if (!(left > 0)) continue;
      pushed[a] += bodies_[a].inverse_mass / give * left * pair.contact.normal;
      pushed[b] -= bodies_[b].inverse_mass / give * left * pair.contact.normal;
    }
    if (!any) break;
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].x += pushed[i];
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
