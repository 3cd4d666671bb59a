// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/moving_state.h"

#include "scene/simulation/piecewise_motion.h"

namespace raygauge {

MovingState state_at(const Motion& motion, double t) {
  const Placement at = motion.at(t);
  const Eigen::Index n = at.t.size();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner(n, n) = at.R;
  MovingState state{Eigen::Vector3d::Zero(), Eigen::Quaterniond(R), Eigen::Vector3d::Zero(),
                    Eigen::Vector3d::Zero()};
  state.place.head(n) = at.t;
  if (const auto* pieces = dynamic_cast<const PiecewiseMotion*>(&motion)) {
    state.velocity = pieces->velocity(t);
    state.spin = pieces->spin(t);
  } else {
    const MotionBound bound = motion.bound(t, t);
    state.velocity.head(n) = bound.velocity;
    state.spin = bound.spin;
  }
  return state;
}

}  // namespace raygauge
