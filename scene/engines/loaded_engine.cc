// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/engines/loaded_engine.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/sets/half_space.h"
#include "results/run/own_module.h"
#include "scene/simulation/moving_state.h"

namespace raygauge {
namespace {

// The principal axes of an inertia, in the axes of the body; these themselves where they are principal.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& inertia) {
  if (inertia.isDiagonal(1e-12)) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return axes;
}

BodyState start_of(const Body& body, const BodyDynamics& how, double t, const Eigen::Matrix3d& axes) {
  const MovingState at = state_at(*body.motion, t);
  const Eigen::Matrix3d R = at.rotation.toRotationMatrix();
  if (!how.reacts()) return {at.place, R, at.velocity, at.spin};
  return {at.place + R * how.center, R * axes, how.velocity, how.spin};
}

Eigen::Vector4d plane_of(const HalfSpace& H) {
  Eigen::Vector4d plane;
  plane << Eigen::Vector3d(H.normal()), H.offset();
  return plane / H.normal().norm();
}

RigidBody part_of(const Body& body, const ConvexSet& set, const Eigen::Vector3d& center,
                  const Eigen::Matrix3d& axes) {
  std::optional<RigidBody> part = RigidBody::of(set);
  if (!part) throw InvalidParameterError("engine: body '" + body.name + "' is none of " + kRigidBodies);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = axes;
  frame.translation() = center;
  part->frame = frame.inverse() * part->frame;
  if (part->frame.isApprox(Eigen::Isometry3d::Identity(), 1e-12)) part->frame.setIdentity();
  return *part;
}

EngineBody engine_body(const Body& body, const BodyDynamics& how, double t, const Eigen::Matrix3d& axes) {
  EngineBody one;
  one.mass = how.mass;
  one.moves = how.reacts() || !body.motion->is_static();
  one.moments = (axes.transpose() * how.inertia * axes).diagonal();
  one.start = start_of(body, how, t, axes);
  for (const BodyPart& part : body.parts) {
    const HalfSpace* H = as_half_space(*part.set);
    if (H == nullptr) one.parts.push_back(part_of(body, *part.set, how.center, axes));
    if (H != nullptr) one.plane = plane_of(*H);
  }
  if (one.plane && one.moves)
    throw InvalidParameterError("engine: body '" + body.name + "' is a half-space and moves");
  return one;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::unique_ptr<PhysicsEngine> create_engine(const std::string& name, const EngineWorld& world) {
  const OwnModule module{"raygauge_" + name + ".so", false,
                         "engine \"" + name + "\" needs lib" + name + "-dev: apt-get install lib" + name +
                             "-dev, and build again"};
  using Create = PhysicsEngine* (*)(const EngineWorld&);
  const auto create = reinterpret_cast<Create>(function_of(module, "raygauge_create_engine"));
  return std::unique_ptr<PhysicsEngine>(create(world));
}

}  // namespace

EngineSteps::EngineSteps(const std::string& name, const Scene& scene, const Dynamics& dynamics)
    : scene_(scene), time_(scene.instants.front()) {
  check_dynamics(scene, dynamics);
  if (scene.dimension() != 3) throw InvalidParameterError("engine: \"" + name + "\" is for scenes of R^3");
  world_.gravity = dynamics.gravity.value_or(Eigen::Vector3d::Zero());
  world_.damping = dynamics.damping;
  world_.step = dynamics.step;
  world_.usual = dynamics.contact;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyDynamics& how = dynamics.bodies[b];
    axes_.push_back(how.reacts() ? principal_axes(how.inertia) : Eigen::Matrix3d::Identity());
    world_.bodies.push_back(engine_body(scene.bodies[b], how, time_, axes_.back()));
  }
  std::set<std::pair<int, int>> ignored;
  for (const auto& [a, b] : scene.ignored) ignored.insert(std::minmax(a, b));
  world_.law = [ignored, dynamics](int a, int b) -> std::optional<ContactLaw> {
    if (ignored.count(std::minmax(a, b)) != 0) return std::nullopt;
    return dynamics.law_of(a, b);
  };
  engine_ = create_engine(name, world_);
}

void EngineSteps::advance(double end, std::vector<BodyState>& bodies) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const EngineBody& body = world_.bodies[b];
    if (body.mass > 0 || !body.moves) continue;
    const MovingState at = state_at(*scene_.bodies[b].motion, end);
    engine_->drive(static_cast<int>(b), {at.place, at.rotation.toRotationMatrix(), at.velocity, at.spin});
  }
  const double begun = seconds_now();
  engine_->step(end - time_);
  seconds_ += seconds_now() - begun;
  time_ = end;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!(world_.bodies[b].mass > 0)) continue;
    bodies[b] = engine_->state(static_cast<int>(b));
    const Eigen::Matrix3d R = bodies[b].R * axes_[b].transpose();
    bodies[b].R = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  }
}

}  // namespace raygauge
