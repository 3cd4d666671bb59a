// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/scene/planning/random_robots.h"

namespace raygauge::soak {

/// What became of the edges of random robots.
struct EdgeSoakTally {
  std::int64_t edges = 0, free = 0, contact = 0, undecided = 0;
  std::int64_t still = 0;    ///< edges of no length
  std::int64_t grazing = 0;  ///< with an obstacle put at the margin, up to 1e-3 of it
  std::int64_t samples = 0;  ///< distances that verdicts were compared with
};

/// Edges of random robots of up to 14 joints (revolute, prismatic, of which some follow others) among
/// obstacles that stand or move, with margins and without, by one checker after the other edges of its robot:
/// whether bodies are apart at 40 moments of an edge that is said to be free, and meet where it is said to be
/// in contact, by newton, cold, for every pair of bodies. In a third of the edges joints start and end at
/// multiples of 45°; in a third an obstacle stands so that at a random moment its distance is the margin but
/// for 0 or 1e-9 to 1e-3.
class RandomEdges {
 public:
  explicit RandomEdges(std::uint64_t seed) : seed_(seed) {}

  /// Robot number `number` of this seed, kEdges edges of it: what is false of a verdict, or nothing.
  std::optional<std::string> check(std::int64_t number);

  static constexpr int kEdges = 10;

  const EdgeSoakTally& tally() const noexcept { return tally_; }

 private:
  std::string error_of(const RobotModel& robot, const std::vector<Body>& bodies, const EdgeOptions& options,
                       const EdgeResult& result, double moment);
  std::string error_at(const Body& a, const Body& b, const EdgeOptions& options, double t);

  std::uint64_t seed_;
  EdgeSoakTally tally_;
};

std::string to_string(const EdgeSoakTally& tally);

}  // namespace raygauge::soak
