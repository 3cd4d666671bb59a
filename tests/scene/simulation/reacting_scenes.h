// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/simulation.h"

/// Scenes of bodies that react, put together in a few lines.
namespace raygauge::reacting_scenes {

inline Eigen::Vector3d v(double x, double y, double z) { return {x, y, z}; }

using Shape = std::shared_ptr<const ConvexSet>;

inline Shape ball(double radius) { return std::make_shared<Ball>(v(0, 0, 0), radius); }
inline Shape box(double x, double y, double z) { return std::make_shared<Box>(v(-x, -y, -z), v(x, y, z)); }
inline Shape floor() { return std::make_shared<Box>(v(-20, -20, -1), v(20, 20, 0)); }

struct Reacting {
  Scene scene;
  Dynamics dynamics;

  explicit Reacting(double to) { scene.instants = {0, to}; }

  /// A body where its frame stands; of mass 0 it does not react.
  void add(const Shape& shape, const Eigen::Vector3d& at, double mass,
           const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity()) {
    const auto name = "body" + std::to_string(scene.bodies.size());
    scene.bodies.push_back(make_body(name, {shape}, std::make_shared<StaticMotion>(make_placement(R, at))));
    BodyDynamics how;
    if (mass > 0) {
      const Moments moments = moments_of(*shape);
      how.mass = mass;
      how.center = moments.center;
      how.inertia = mass / moments.measure * moments.inertia();
    }
    dynamics.bodies.push_back(how);
  }
};

}  // namespace raygauge::reacting_scenes
