// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "scene/simulation/simulator.h"

// What a Simulator records of its steps, what it stores, and how it goes on from there.
namespace raygauge {

Simulation Simulator::run(const SimulationHooks& hooks, std::span<const SimulationPart> before) {
  hooks_ = hooks;
  const double from = t_, to = out_.scene.instants.back();
  if (before.empty() || dynamics_.overlap_at_start == StartOverlap::resolved) come_to_start();
  StepRecord start;
  add_energy(start);
  out_.energy_at_start = start.kinetic + start.potential;
  if (!before.empty()) go_on(before);
  if (!hooks_.advance) make_steppers();
  const auto count = static_cast<std::int64_t>(std::ceil((to - from) / dynamics_.step * (1 - 1e-12)));
  SimulationState ended;
  if (hooks_.store) ended = state();
  bool goes_on = true;
  for (auto k = static_cast<std::int64_t>(log_.steps.size()) + 1; k <= count && goes_on; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    goes_on = do_step(k == count ? to : from + share * (to - from));
    if (goes_on && hooks_.store) ended = state();
    if (hooks_.progress) hooks_.progress(share);
    if (hooks_.store && (!goes_on || k == count || (hooks_.due && hooks_.due())))
      hooks_.store(log_.next_part(ended));
  }
  if (!ended_by_.empty()) throw SimulationError(ended_by_, result());
  return result();
}

// False: it is to stop or cannot go on, and the step is taken back.
bool Simulator::do_step(double to) {
  const double begin = t_;
  log_.begin_step();
  row_ = StepRecord();
  try {
    out_.stopped = !step(to);
  } catch (const InvalidParameterError& /*mistake*/) {
    throw;
  } catch (const Error& error) {
    ended_by_ = error.what();
  }
  if (!out_.stopped && ended_by_.empty()) {
    record_step();
    return true;
  }
  log_.take_step_back();
  t_ = begin;
  return false;
}

Simulation Simulator::result() {
  out_.contacts = std::move(log_.contacts);
  out_.steps = std::move(log_.steps);
  out_.counters = log_.counters;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!bodies_[b].reacts() || log_.pieces[b].empty()) continue;
    out_.scene.bodies[b].motion = std::make_shared<PiecewiseMotion>(std::move(log_.pieces[b]), t_);
  }
  if (!ended_by_.empty()) end_instants();
  return std::move(out_);
}

void Simulator::end_instants() {
  std::vector<double>& instants = out_.scene.instants;
  instants.erase(std::lower_bound(instants.begin(), instants.end(), t_), instants.end());
  instants.push_back(t_);
}

SimulationState Simulator::state() const {
  SimulationState now;
  now.time = t_;
  for (const SimulatedBody& body : bodies_) {
    now.bodies.emplace_back();
    if (body.reacts()) now.bodies.back() = {body.x, body.R, body.v, body.L};
  }
  for (const ContactUnknown& one : last_) now.impulses.push_back({one.a, one.b, one.at, one.impulse});
  now.normals = normals_;
  return now;
}

void Simulator::go_on(std::span<const SimulationPart> before) {
  for (const SimulationPart& part : before) log_.add(part);
  const SimulationState& state = before.back().state;
  t_ = state.time;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    SimulatedBody& body = bodies_[b];
    if (!body.reacts()) continue;
    const BodyBetweenSteps& then = state.bodies[b];
    body.x = then.x;
    body.R = then.R;
    body.v = then.v;
    body.L = then.L;
    body.spin = body.rotor.spin(body.R, body.L);
  }
  for (const KnownImpulse& one : state.impulses) {
    ContactUnknown& contact = last_.emplace_back();
    contact.a = one.a;
    contact.b = one.b;
    contact.at = one.at;
    contact.impulse = one.impulse;
  }
  normals_ = state.normals;
}

void Simulator::record_step() {
  add_energy(row_);
  log_.steps.push_back(row_);
}

void Simulator::add_energy(StepRecord& row) const {
  row.time = t_;
  row.momentum.setZero();
  row.angular_momentum.setZero();
  for (const SimulatedBody& body : bodies_) {
    if (!body.reacts()) continue;
    row.kinetic += body.kinetic_energy();
    if (dynamics_.gravity) row.potential -= body.mass * dynamics_.gravity->dot(body.x);
    row.momentum += body.mass * body.v;
    row.angular_momentum += body.L + body.x.cross(body.mass * body.v);
  }
}

SimulationError::SimulationError(const std::string& why, Simulation done)
    : Error(why), done_(std::make_shared<const Simulation>(std::move(done))) {}

Simulation simulate(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction,
                    const SimulationHooks& hooks, std::span<const SimulationPart> before) {
  return Simulator(scene, dynamics, friction).run(hooks, before);
}

}  // namespace raygauge
