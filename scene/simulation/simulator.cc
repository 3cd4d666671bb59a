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

constexpr int kMostTrials = 12;      // of one substep, shorter each time
constexpr int kMostBounces = 200;    // at one moment; then bodies do not rebound any more
constexpr int kMostCorrections = 3;  // of one contact problem
constexpr double kShortest = 1e-9;   // of the step: shorter substeps make no progress

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
    : dynamics_(dynamics),
      n_(scene.dimension()),
      log_(scene.bodies.size()),
      problem_(n_, friction, log_.counters) {
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
    one.reach = own.reach;
    one.still = false;
  }
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

// Until the end of the step, no further than bodies that are driven keep their velocities, and than one turn
// of a radian of bodies that turn about no principal axis.
double Simulator::longest_substep(double to) const {
  double dt = to - t_;
  for (const SimulatedBody& body : bodies_) {
    if (!body.reacts()) dt = std::min(dt, body.motion->next_break(t_) - t_);
    if (body.reacts() && n_ == 3 && !constant_spin(body.rotor, body.R, body.L, dt))
      dt = std::min(dt, 0.5 / body.spin.norm());
  }
  return dt;
}

void Simulator::follow_motions() {
  for (SimulatedBody& body : bodies_) {
    if (body.reacts()) {
      body.motion = nullptr;
      continue;
    }
    const Placement at = body.motion->at(t_);
    const MotionBound bound = body.motion->bound(t_, t_);
    body.x = in_space(at.t);
    body.R = in_space(at.R);
    body.v = in_space(bound.velocity);
    body.spin = bound.spin;
  }
}

// False: it is to stop, and is not at the end.
bool Simulator::step(double to) {
  bounces_ = 0;
  end_of_step_ = to;
  while (t_ < to) {
    if (stop_now()) return false;
    if (hooks_.advance) {
      advance(to);
      continue;
    }
    const double dt = longest_substep(to);
    follow_motions();
    near_ = &pairs_->find(t_, dt);
    choose_roles(dt);
    if (bounce()) {
      while (bounce()) {
      }
      continue;
    }
    if (!move(dt)) row_.least_distance = -kInfinity;
  }
  return true;
}

// How fast a point of contact closes, now.
double Simulator::approach(const NearPair& pair, const GapPoint& point) const {
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  return -(a.velocity_at(point.at) - b.velocity_at(point.at)).dot(pair.contact.normal);
}

// The acceleration at which gravity presses them together.
double Simulator::pressing(const NearPair& pair) const {
  if (!dynamics_.gravity) return 0;
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  const double share = (a.reacts() ? 1.0 : 0.0) - (b.reacts() ? 1.0 : 0.0);
  return -share * dynamics_.gravity->dot(pair.contact.normal);
}

// A rebound is computed where it leads farther away than δ, before the bodies meet again or within a step.
bool Simulator::is_rebound(const NearPair& pair, double approach) const {
  const double speed = pair.law.restitution.value_or(0) * approach;
  if (!(speed > 0) || bounces_ > kMostBounces) return false;
  const double a = pressing(pair);
  return (a > 0 ? speed * speed / (2 * a) : speed * dynamics_.step) > scales_.delta;
}

double Simulator::closing_speed(const NearPair& pair) const {
  double fastest = -kInfinity;
  for (const GapPoint& point : pair.contact.points) fastest = std::max(fastest, approach(pair, point));
  return fastest;
}

PairRole Simulator::role_of(const NearPair& pair, double dt) const {
  const double fastest = pair.closing;
  const double a = pressing(pair), speed = std::fabs(fastest);
  const bool far = (a > 0 ? speed * speed / (2 * a) : speed * dynamics_.step) > scales_.delta;
  if (pair.contact.lower <= scales_.touching())
    return fastest < 0 && far ? PairRole::leaving : PairRole::contact;
  const bool meets = pair.contact.lower - dt * fastest - std::max(a, 0.0) * dt * dt <= 0;
  return meets && !far ? PairRole::contact : PairRole::apart;
}

void Simulator::choose_roles(double dt) {
  for (NearPair& pair : *near_) {
    pair.closing = closing_speed(pair);
    pair.role = role_of(pair, dt);
    pair.correction = 0;
  }
}

// Newton's law at the points that touch and close: u_n after = -e u_n before, with friction. Points that do
// not close have no part in it: blows go on from body to body. False: none closes so fast that it rebounds.
bool Simulator::bounce() {
  bool any = false;
  std::vector<ContactUnknown> contacts;
  for (const NearPair& pair : *near_) {
    if (pair.contact.lower > scales_.touching()) continue;
    for (const GapPoint& point : pair.contact.points) {
      if (point.gap > scales_.touching()) continue;
      const double speed = approach(pair, point);
      if (!(speed > 0)) continue;
      const bool rebound = is_rebound(pair, speed);
      any = any || rebound;
      contacts.push_back({pair.a, pair.b, point.at, pair.contact.normal, point.gap,
                          rebound ? -*pair.law.restitution * speed : 0.0, pair.law.friction,
                          Eigen::Vector3d::Zero()});
    }
  }
  if (!any) return false;
  ++bounces_;
  ++row_.impacts;
  ++log_.counters.impact_problems;
  const std::vector<SimulatedBody> before = bodies_;
  row_.residual = std::max(row_.residual, problem_.solve(contacts, bodies_));
  std::vector<double> energies(before.size());
  std::transform(before.begin(), before.end(), energies.begin(),
                 [](const SimulatedBody& body) { return body.kinetic_energy(); });
  limit_energy(contacts, before, std::move(energies));
  record_contacts(contacts, true);
  return true;
}

// One substep of at most dt, shorter where the proof ends; false: its end could not be proven.
bool Simulator::move(double dt) {
  const std::vector<SimulatedBody> before = bodies_;
  const double shortest = kShortest * dynamics_.step;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    bodies_ = before;
    if (stop_now()) return true;  // nothing was done
    bool possible = push_and_move(dt, before);
    while (possible && catch_leaving()) {
      bodies_ = before;
      possible = push_and_move(dt, before);
    }
    for (int k = 0; possible && k < kMostCorrections && corrected(dt); ++k) {
      bodies_ = before;
      possible = push_and_move(dt, before);
    }
    if (!possible) {
      dt /= 2;
      bodies_ = before;
      choose_roles(dt);  // what was asked of the longer one is no longer
      continue;
    }
    const double end = end_of(dt);
    const double proven = dynamics_.contact ? pairs_->proven_until(t_, end) : end;
    if (proven >= end) {
      if (!pairs_->nothing_touched()) row_.least_distance = std::min(row_.least_distance, -scales_.delta);
      commit(end, before);
      return true;
    }
    if (proven - t_ < shortest) {
      dt = std::min(dt, 1e-2 * dynamics_.step);
      break;
    }
    dt = trial < 3 ? proven - t_ : std::min(proven - t_, dt / 2);
    bodies_ = before;
    choose_roles(dt);
  }
  if (!push_and_move(dt, bodies_ = before)) throw InvalidParameterError("dynamics: a body spins too fast");
  commit(end_of(dt), before);
  return false;
}

double Simulator::end_of(double dt) const {
  const double end = t_ + dt;
  return end_of_step_ - end < 1e-12 * dynamics_.step ? end_of_step_ : end;
}

}  // namespace raygauge
