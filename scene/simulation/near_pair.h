// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>

#include "raygauge/scene/continuous.h"
#include "raygauge/simulation.h"
#include "scene/simulation/contact_finder.h"

namespace raygauge {

/// What a step does with two parts that are near each other.
enum class PairRole : std::uint8_t {
  apart,    ///< it takes care that they do not touch before its end
  contact,  ///< they belong to the contact problem
  leaving,  ///< they touch and separate
};

/// Two parts that may meet within a step.
struct NearPair {
  int part_a = 0, part_b = 0;
  int a = 0, b = 0;  ///< bodies
  ContactLaw law;
  PartContact contact;
  double closing = 0;  ///< the highest speed at which a point of the contact closes, before the step
  PairRole role = PairRole::apart;
  double correction = 0;  ///< <= 0: what the end of the step was closer than its contact problem said
};

/// Distances that matter, in units of the scene.
struct ContactScales {
  double delta = 0;                                       ///< δ
  double touching() const noexcept { return delta / 2; }  ///< from here on bodies touch
  double arrival() const noexcept { return delta / 4; }   ///< the distance at which an impact is computed
};

/// What a look found, and of what; or that planes across its normal are so far apart now (no band).
struct KnownLook {
  Placement at_a, at_b;
  Eigen::Vector3d previous;  ///< normal
  double band = -1;
  PartContact contact;

  bool is_of(const Placement& a, const Placement& b) const {
    return at_a.t == a.t && at_a.R == a.R && at_b.t == b.t && at_b.R == b.R;
  }
};

/// Two parts of bodies one of which reacts, and what is known of them.
struct CandidatePair {
  int part_a, part_b;
  ContactLaw law;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of the last find(), where it was near
  int near = -1;                                      ///< its number among the near pairs
  std::unique_ptr<KnownLook> known;                   ///< the last one, of few candidates
};

/// What one thread needs to look at pairs. It counts for itself.
struct PairTools {
  PairTools(int dimension, double miss);
  ~PairTools();

  Pose pose_a, pose_b;
  ContactFinder finder;
  ContinuousSolver solver;
  std::unique_ptr<class PairSolver> planes;
  SimulationCounters counters;
};

}  // namespace raygauge
