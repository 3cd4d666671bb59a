// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "raygauge/simulation.h"

namespace raygauge::soak {

/// What became of the simulations.
struct SimulationSoakTally {
  std::int64_t scenes = 0, bodies = 0, steps = 0, cuts = 0, contacts = 0, impacts = 0;
  std::int64_t checks = 0;  ///< signed distances of pairs at single moments
  std::int64_t rough = 0;   ///< steps whose residual is above 1e-8
  double residual = 0;      ///< the largest, in ...
  std::int64_t worst_scene = 0;
  std::int64_t jammed = 0;  ///< scenes that end where driven bodies jam others
  double rise = 0;          ///< of the energy in a step, relative: the largest
};

/// Random scenes of 2 to 30 bodies of every shape that fall, hit and slide, in R^2 and R^3: all numbers stay
/// finite, each step is proven, no pair is deeper than δ by an independent query, and the energy does not
/// rise beyond the residual where nothing drives a body. Where a driven body jams others, all of this holds
/// of the steps before.
class RandomSimulations {
 public:
  explicit RandomSimulations(std::uint64_t seed);

  /// Scene number `number` of this seed: what is false of its simulation, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const SimulationSoakTally& tally() const noexcept { return tally_; }

 private:
  std::string error_of(const Simulation& found, const Dynamics& dynamics, bool driven);
  std::string energy_error(const Simulation& found, const Dynamics& dynamics);
  std::string depth_error(const Simulation& found, const Dynamics& dynamics, double t);

  std::uint64_t seed_;
  std::int64_t number_ = 0;  ///< of the scene that is checked
  SimulationSoakTally tally_;
};

std::string to_string(const SimulationSoakTally& tally);

}  // namespace raygauge::soak
