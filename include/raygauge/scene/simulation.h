// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "raygauge/scene/dynamics.h"
#include "raygauge/scene/friction.h"
#include "raygauge/scene/scene.h"

namespace raygauge {

/// A contact that carried an impulse.
struct ContactRecord {
  std::int64_t step = 0;
  double time = 0;  ///< of the beginning of the substep; of an impact, its moment
  std::int32_t body_a = 0, body_b = 0;
  bool impact = false;            ///< by Newton's law of restitution, at one moment
  Eigen::Vector3d point, normal;  ///< in space; the normal points from b to a
  double gap = 0;
  Eigen::Vector3d impulse;  ///< on a, during the substep or at the impact
};

/// What is known of one step.
struct StepRecord {
  double time = 0;            ///< of its end
  std::int64_t substeps = 0;  ///< 1 + how often it was cut
  std::int64_t impacts = 0;   ///< impact laws evaluated
  std::int64_t contacts = 0;  ///< points of contact problems solved
  double residual = 0;        ///< the largest of those problems, see friction_residual(); NaN: not known
  double least_distance = 0;  ///< proven: no pair came closer at any time of the step; -infinity: unproven
  double kinetic = 0, potential = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();          ///< of all bodies that react
  Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  ///< the same, about the origin
};

/// How often what was computed; what is not named in Dynamics stays 0.
struct SimulationCounters {
  std::int64_t ball_tests = 0;       ///< pairs of parts apart by their bounding balls and speeds
  std::int64_t contact_queries = 0;  ///< signed distances with contact points
  std::int64_t motion_proofs = 0;    ///< proofs about a pair over a substep
  std::int64_t friction_problems = 0, frictionless_problems = 0, impact_problems = 0;
  std::int64_t damped_velocities = 0;

  SimulationCounters& operator+=(const SimulationCounters& more);
};

/// A simulated scene: its bodies, moved so that their origins are their centres of mass, under the motions
/// that were computed.
struct Simulation {
  Scene scene;
  std::vector<ContactRecord> contacts;
  std::vector<StepRecord> steps;
  SimulationCounters counters;
  double tolerance = 0;        ///< δ, in units of the scene
  double energy_at_start = 0;  ///< kinetic and potential
  double moved_at_start = 0;   ///< how far the centre of a body was moved at most, of bodies that overlapped
  bool stopped = false;
};

struct SimulationPart;  // scene/simulation/simulation_part.h

/// Where a body is, by its centre of mass, and how it moves. In the plane vectors have zeros behind them.
struct BodyState {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  ///< angular velocity, in space
};

struct SimulationHooks {
  int threads = 1;  ///< share groups of bodies, and a large one's pairs; what is found does not depend on it
  std::function<bool()> stop;                  ///< true: end here; a step that is not done is taken back
  std::function<void(double share)> progress;  ///< of the time that is done
  std::function<bool()> due;                   ///< after a step: whether to call `store` now
  std::function<void(const SimulationPart& part)>
      store;  ///< what happened since its last call; also at the end
  /// Another engine: it takes a step until `end`, and sets the states of the bodies that react, of all bodies
  /// in the order of the scene. Between the ends of a step each moves and turns evenly. Of this motion the
  /// least signed distance is proven, and no limit is kept.
  std::function<void(double end, std::vector<BodyState>& bodies)> advance;
};

/// Lets the bodies of the scene react, from its first instant to its last, in steps of at most dynamics.step.
/// Free flight is exact for constant forces. Contacts follow Moreau and Jean's time stepping in velocities
/// and impulses, restitution acts at proven times of impact. Of every step it is proven that no pair of
/// bodies comes closer than -δ; a step of which that is not so is cut where the proof ends.
///
/// `friction` solves contact problems with friction that Newton's method does not solve; it may be nullptr.
/// Throws what check_dynamics() throws, and InvalidParameterError for bodies that overlap by more than δ at
/// the start (see StartOverlap).
///
/// `before`: what an earlier call has stored of the same scene and dynamics; this one goes on from there, and
/// finds bit for bit what one call would have.
Simulation simulate(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction,
                    const SimulationHooks& hooks = {}, std::span<const SimulationPart> before = {});

}  // namespace raygauge
