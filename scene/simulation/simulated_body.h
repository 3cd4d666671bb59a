// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "raygauge/scene/scene.h"
#include "raygauge/simulation.h"
#include "scene/simulation/free_rotation.h"
#include "scene/simulation/piecewise_motion.h"

namespace raygauge {

/// A body of a simulation: its origin is its centre of mass. In the plane vectors have zeros behind them.
struct SimulatedBody {
  double mass = 0;  ///< 0: it stands or follows its motion
  double inverse_mass = 0;
  Rotor rotor;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d L = Eigen::Vector3d::Zero();     ///< angular momentum about x, of one that reacts
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  ///< angular velocity
  MotionPointer motion;  ///< over the substep in work; of bodies that do not react, all of it
  MotionPiece piece;     ///< the same, of one that reacts
  double reach = 0;      ///< of its points, from x
  bool still = false;    ///< its motion over the substep in work is none

  bool reacts() const noexcept { return mass > 0; }
  /// R J⁻¹ Rᵀ is it times its transpose.
  Eigen::Matrix3d inverse_inertia_root() const { return R * rotor.root; }

  /// Adds an impulse p at a point.
  void push(const Eigen::Vector3d& p, const Eigen::Vector3d& at) {
    v += inverse_mass * p;
    L += (at - x).cross(p);
    spin = rotor.spin(R, L);
  }

  /// Those of another state.
  void take_velocities(const SimulatedBody& other) {
    v = other.v;
    L = other.L;
    spin = other.spin;
  }

  void scale_velocities(double factor) {
    v *= factor;
    L *= factor;
    spin *= factor;
  }

  Eigen::Vector3d velocity_at(const Eigen::Vector3d& point) const { return v + spin.cross(point - x); }

  double kinetic_energy() const { return reacts() ? (mass * v.squaredNorm() + spin.dot(L)) / 2 : 0; }
};

/// One convex part, as the body that it is alone.
struct SimulatedPart {
  int owner = 0;
  Body body;
};

}  // namespace raygauge
