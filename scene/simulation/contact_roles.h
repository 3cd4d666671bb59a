// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/simulation.h"
#include "scene/simulation/near_pair.h"
#include "scene/simulation/simulated_body.h"

namespace raygauge {

/// What bodies that are near each other do to one another within a substep: they stay apart, are in contact,
/// or rebound and leave. By the velocities that the bodies have when it is asked.
class ContactRoles {
 public:
  /// All must outlive it.
  ContactRoles(const Dynamics& dynamics, ContactScales scales, const std::vector<SimulatedBody>& bodies)
      : dynamics_(dynamics), scales_(scales), bodies_(bodies) {}

  /// The role of each pair, which has no correction yet.
  void choose(std::vector<NearPair>& near, double dt) const;

  /// How fast a point of contact closes, and the fastest one of a pair.
  double approach(const NearPair& pair, const GapPoint& point) const;
  double closing_speed(const NearPair& pair) const;

  /// Whether a pair that closes at this speed rebounds.
  bool is_rebound(const NearPair& pair, double approach) const;

  /// Rebounds at one moment are counted: when there were many, bodies do not rebound any more until the next.
  void begin_moment() noexcept { bounces_ = 0; }
  void count_bounce() noexcept { ++bounces_; }
  void end_bounces() noexcept;

 private:
  double pressing(const NearPair& pair) const;
  PairRole role_of(const NearPair& pair, double dt) const;

  const Dynamics& dynamics_;
  ContactScales scales_;
  const std::vector<SimulatedBody>& bodies_;
  int bounces_ = 0;
};

}  // namespace raygauge
