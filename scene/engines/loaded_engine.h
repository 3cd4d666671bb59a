// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "scene/engines/physics_engine.h"

namespace raygauge {

/// SimulationHooks::advance by an engine of physics, and the seconds that its steps took.
class EngineSteps {
 public:
  /// Loads the engine of that name, "bullet", "ode" or "mujoco". Throws Error in a build without it, and says
  /// what to install; InvalidParameterError for what it does not take: the plane, sets that are no RigidBody,
  /// half-spaces that move. `scene` must outlive this.
  EngineSteps(const std::string& name, const Scene& scene, const Dynamics& dynamics);

  void advance(double end, std::vector<BodyState>& bodies);
  double seconds() const noexcept { return seconds_; }

 private:
  const Scene& scene_;
  EngineWorld world_;
  std::vector<Eigen::Matrix3d> axes_;  ///< of each body, the engine's in its own
  std::unique_ptr<PhysicsEngine> engine_;
  double time_ = 0;
  double seconds_ = 0;
};

}  // namespace raygauge
