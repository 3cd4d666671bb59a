// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "raygauge/scene/motion.h"

namespace raygauge {

/// Where a body is and how it moves at a moment. In the plane vectors have zeros behind them.
struct MovingState {
  Eigen::Vector3d place;        ///< of its origin: of one that was simulated, the centre of mass
  Eigen::Quaterniond rotation;  ///< of its axes
  Eigen::Vector3d velocity;     ///< of its origin
  Eigen::Vector3d spin;         ///< angular velocity, in space
};

/// The state at t; of a motion of pieces, that of the later one where two meet.
MovingState state_at(const Motion& motion, double t);

}  // namespace raygauge
