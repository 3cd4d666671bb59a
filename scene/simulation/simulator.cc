// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/simulator.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"
#include "scene/simulation/piecewise_motion.h"
#include "scene/simulation/similar_set.h"

namespace raygauge {
namespace {

Body about_center(const Body& body, const Eigen::Vector3d& center) {
  const int n = body.dimension();
  if (center.isZero(0)) return body;
  std::vector<std::shared_ptr<const ConvexSet>> parts;
  for (const BodyPart& part : body.parts)
    parts.push_back(similar_set(part.set, 1, SmallVector(-center.head(n))));
  const Placement at = body.motion->at(0);
  return make_body(
      body.name, parts,
      std::make_shared<StaticMotion>(Placement{at.R, at.R * SmallVector(center.head(n)) + at.t}));
}

}  // namespace

Simulator::Simulator(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction)
    : dynamics_(dynamics), n_(scene.dimension()), log_(scene.bodies.size()), friction_(friction) {
  check_dynamics(scene, dynamics);
  out_.scene = scene;
  t_ = scene.instants.front();
  double smallest = kInfinity;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    add_body(scene.bodies[b], dynamics.bodies[b]);
    if (dynamics.bodies[b].reacts()) smallest = std::min(smallest, out_.scene.bodies[b].ball.radius);
  }
  scales_.delta = out_.tolerance = dynamics.tolerance * smallest;
  make_parts();
  pairs_.emplace(scene, dynamics, bodies_, parts_, scales_, log_.counters);
}

void Simulator::add_body(const Body& body, const BodyDynamics& how) {
  Body& own = out_.scene.bodies[bodies_.size()];
  SimulatedBody one;
  one.motion = body.motion;
  one.still = body.motion->is_static();
  if (how.reacts()) {
    own = about_center(body, how.center);
    const Placement at = own.motion->at(t_);
    one.mass = how.mass;
    one.inverse_mass = 1 / how.mass;
    one.rotor.J =
        n_ == 2 ? Eigen::Matrix3d(Eigen::Vector3d(1, 1, how.inertia(2, 2)).asDiagonal()) : how.inertia;
    one.rotor.J_inverse = one.rotor.J.inverse();
    one.rotor.root = one.rotor.J_inverse.llt().matrixL();
    one.x = in_space(at.t);
    one.R = in_space(at.R);
    one.v = how.velocity;
    one.spin = how.spin;
    one.L = one.R * one.rotor.J * one.R.transpose() * how.spin;
    one.motion = nullptr;
    one.still = false;
  }
  one.reach = own.reach;
  bodies_.push_back(std::move(one));
}

void Simulator::make_parts() {
  if (!dynamics_.contact) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = out_.scene.bodies[b];
    for (const BodyPart& part : body.parts)
      parts_.push_back({static_cast<int>(b), make_body(body.name, {part.set}, body.motion)});
  }
}

}  // namespace raygauge
