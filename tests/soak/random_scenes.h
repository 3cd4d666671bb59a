// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "raygauge/scene/scene_run.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::soak {

/// What became of the scenes.
struct SceneSoakTally {
  std::int64_t scenes = 0;
  std::int64_t records = 0;    ///< answers that were compared
  std::int64_t left_out = 0;   ///< pairs at an instant that a query with `within` or `nearest` left out
  std::int64_t undecided = 0;  ///< records without an answer
};

/// Random scenes of 3 to 6 bodies of R^2 and R^3 with every effect, metric and limit, whose answers are
/// compared with brute force: each pair at each instant, cold, by the general methods.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : seed_(seed) {}

  /// Scene number `number` of this seed: what is false of its answers, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const SceneSoakTally& tally() const noexcept { return tally_; }

 private:
  std::string compare(const Scene& scene, const SceneCellResult& result);
  std::string row_error(const Scene& scene, const SceneRecord& row);
  std::string instant_error(const SceneRecord& row, const random_scenes::BruteForce& truth);
  std::string left_out_error(const Scene& scene, const SceneCellResult& result, int query);

  std::uint64_t seed_;
  SceneSoakTally tally_;
};

std::string to_string(const SceneSoakTally& tally);

}  // namespace raygauge::soak
