// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "baselines/rigid_body.h"
#include "raygauge/simulation.h"

namespace raygauge {

/// A body as engines of physics have it: its axes are the principal ones of its inertia, about its centre of
/// mass, where it reacts.
struct EngineBody {
  std::vector<RigidBody> parts;
  std::optional<Eigen::Vector4d>
      plane;           ///< in place of parts: {x : n·x <= c}, (n, c) in the body's axes, |n| = 1
  double mass = 0;     ///< 0: it stands, or follows a motion
  bool moves = false;  ///< it reacts, or follows a motion
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< of inertia
  BodyState start;
};

/// What an engine is to simulate.
struct EngineWorld {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::optional<Damping> damping;
  std::vector<EngineBody> bodies;
  std::optional<ContactLaw> usual;  ///< the law of most pairs
  /// The law of two bodies; none: they pass through each other.
  std::function<std::optional<ContactLaw>(int a, int b)> law;
  double step = 0;
};

/// Another engine of physics, one file each, in a module of its own. All tunables that a scene does not name
/// are the engine's own defaults.
class PhysicsEngine {
 public:
  virtual ~PhysicsEngine() = default;

  /// Of bodies that follow a motion: where it is at the end of the step to come, and how it moves.
  virtual void drive(int body, const BodyState& state) = 0;

  virtual void step(double dt) = 0;

  virtual BodyState state(int body) const = 0;
};

}  // namespace raygauge
