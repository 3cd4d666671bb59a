// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raygauge/simulation.h"
#include "scene/simulation/piecewise_motion.h"

namespace raygauge {

/// A body that reacts, between two steps. Of others zeros.
struct BodyBetweenSteps {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d L = Eigen::Vector3d::Zero();  ///< angular momentum about x
};

/// The impulse of a contact: a first guess for the next step.
struct KnownImpulse {
  std::int32_t a = 0, b = 0;
  Eigen::Vector3d at, impulse;
};

/// The normal of two parts that are near each other: for where they touch and none is found.
struct KnownNormal {
  std::int32_t part_a = 0, part_b = 0;
  Eigen::Vector3d normal;
};

/// All that the next step depends on, besides the scene and its dynamics.
struct SimulationState {
  double time = 0;
  std::vector<BodyBetweenSteps> bodies;  ///< of each body of the scene
  std::vector<KnownImpulse> impulses;
  std::vector<KnownNormal> normals;
};

/// A stretch of a simulation: what happened in it, and where it ended.
struct SimulationPart {
  std::int64_t first_step = 0;  ///< its number among all
  std::vector<StepRecord> steps;
  std::vector<ContactRecord> contacts;
  std::vector<std::vector<MotionPiece>> pieces;  ///< of each body
  SimulationCounters counters;                   ///< since the beginning
  SimulationState state;
};

/// What a simulation has recorded. A step that was begun can be taken back.
class SimulationLog {
 public:
  explicit SimulationLog(std::size_t bodies = 0)
      : pieces(bodies), begun_{0, 0, Counts(bodies), {}}, stored_(begun_) {}

  std::vector<StepRecord> steps;
  std::vector<ContactRecord> contacts;
  std::vector<std::vector<MotionPiece>> pieces;
  SimulationCounters counters;

  void begin_step();
  void take_step_back();

  /// What was recorded since the last call, without a step that was begun.
  SimulationPart next_part(SimulationState state);

  /// Puts a part of an earlier run behind what there is. Throws InvalidParameterError where it does not
  /// follow.
  void add(const SimulationPart& part);

 private:
  using Counts = std::vector<std::size_t>;
  struct Ends {
    std::size_t steps = 0, contacts = 0;
    Counts pieces;
    SimulationCounters counters;
  };
  Ends ends() const;

  Ends begun_, stored_;
};

}  // namespace raygauge
