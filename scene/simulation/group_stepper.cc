// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/group_stepper.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr int kMostTrials = 60;      // of one substep, shorter or with more contacts each time
constexpr int kMostJoins = 20;       // after which they are only shorter
constexpr int kMostCorrections = 3;  // of one contact problem
constexpr double kShortest = 1e-9;   // of the step: shorter substeps make no progress
constexpr double kUnproven = 1e-2;   // of the step: a substep that could not be proven
// Of a substep whose contacts bend too much: what is tried next. Steps after it are at most twice as long
// each.
constexpr double kBent = 0.125;

std::string name_of(const std::vector<SimulatedPart>& parts, int number) {
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [number](const SimulatedPart& one) { return one.owner == number; });
  return part == parts.end() ? std::to_string(number) : "'" + part->body.name + "'";
}

[[noreturn]] void refuse_spin(const std::vector<SimulatedPart>& parts, int number, double t) {
  throw Error("simulation: at " + std::to_string(t) + " s body " + name_of(parts, number) +
              " spins too fast for its steps to be proven; take shorter ones");
}

// Bodies that do not react close in on others, which no impulse gets away.
[[noreturn]] void refuse_jam(const std::vector<int>& jam, const std::vector<SimulatedBody>& bodies,
                             const std::vector<SimulatedPart>& parts, double t) {
  std::string around, jammed;
  for (const int b : jam) {
    std::string& names = bodies[static_cast<std::size_t>(b)].reacts() ? jammed : around;
    names += (names.empty() ? "" : ", ") + name_of(parts, b);
  }
  throw Error("simulation: at " + std::to_string(t) + " s " + jammed + " is jammed by " + around +
              ": no impulses keep them apart");
}

// A pair that was thought to stay apart, and that its turn or the impulses of others bring together: where it
// does not rebound, it joins the problem, and cuts no substep.
bool join_late(NearPair* pair) {
  if (pair == nullptr || pair->role != PairRole::apart || pair->law.restitution.value_or(0) > 0) return false;
  pair->role = PairRole::contact;
  return true;
}

}  // namespace

GroupStepper::GroupStepper(const Dynamics& dynamics, const NearPairs& pairs,
                           const std::vector<SimulatedBody>& bodies, std::vector<SimulatedPart> parts,
                           FrictionSolver* friction, std::function<bool()> stop)
    : dynamics_(dynamics),
      n_(pairs.dimension()),
      scales_(pairs.scales()),
      bodies_(bodies),
      parts_(std::move(parts)),
      stop_(std::move(stop)),
      pairs_(pairs, bodies_, parts_, counters_),
      roles_(dynamics_, scales_, bodies_),
      problem_(n_, friction, counters_),
      before_(bodies),
      free_(bodies),
      limited_(bodies),
      pieces_(bodies.size()) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].reacts()) continue;
    driven_.push_back(static_cast<int>(b));
    if (bodies[b].still)
      follow_motion(driven_.back());
    else
      moved_.push_back(driven_.back());
  }
}

void GroupStepper::share_with(ChunkTeam& team, int threads) {
  pairs_.share_with(team, threads);
  problem_.share_with(team);
}

GroupStep GroupStepper::step(const BodyGroup& group, const std::vector<SimulatedBody>& bodies, double from,
                             double to, std::int64_t number) {
  result_ = GroupStep();
  result_.row.substeps = 0;
  number_ = number;
  t_ = from;
  end_of_step_ = to;
  roles_.begin_moment();
  bent_dt_ = kInfinity;
  active_ = group.bodies;
  std::vector<int> members = driven_;
  members.insert(members.end(), active_.begin(), active_.end());
  std::sort(members.begin(), members.end());
  for (const int b : active_) {
    body(b) = bodies[static_cast<std::size_t>(b)];
    pieces_[static_cast<std::size_t>(b)].clear();
  }
  last_.remember(group.last, dynamics_.step);
  pairs_.begin(members, group.normals);
  result_.done = go_on(to);
  result_.normals = pairs_.end();
  result_.last = last_.contacts();
  for (const int b : active_) {
    result_.bodies.push_back(body(b));
    result_.pieces.push_back(std::move(pieces_[static_cast<std::size_t>(b)]));
  }
  return std::move(result_);
}

SimulationCounters GroupStepper::take_counters() { return std::exchange(counters_, SimulationCounters()); }

void GroupStepper::copy_active(const std::vector<SimulatedBody>& from, std::vector<SimulatedBody>& to) const {
  for (const int b : active_) to[static_cast<std::size_t>(b)] = from[static_cast<std::size_t>(b)];
}

// Until the end of the step, no further than bodies that are driven keep their velocities, and than one turn
// of a radian of bodies that turn about no principal axis.
double GroupStepper::longest_substep(double to) const {
  double dt = to - t_;
  for (const int b : moved_) dt = std::min(dt, body(b).motion->next_break(t_) - t_);
  for (const int b : active_) {
    const SimulatedBody& body = this->body(b);
    if (body.spin.norm() * dynamics_.step > kMostRadiansOfStep) refuse_spin(parts_, b, t_);
    if (n_ == 3 && !constant_spin(body.rotor, body.R, body.L, dt)) dt = std::min(dt, 0.5 / body.spin.norm());
  }
  return dt;
}

// To where a body that does not react is now, in all copies.
void GroupStepper::follow_motion(int number) {
  SimulatedBody& body = this->body(number);
  const Placement at = body.motion->at(t_);
  const MotionBound bound = body.motion->bound(t_, t_);
  body.x = in_space(at.t);
  body.R = in_space(at.R);
  body.v = in_space(bound.velocity);
  body.spin = bound.spin;
  for (std::vector<SimulatedBody>* const copy : {&before_, &free_, &limited_})
    (*copy)[static_cast<std::size_t>(number)] = body;
}

// False: it is to stop, and is not at the end.
bool GroupStepper::go_on(double to) {
  while (t_ < to) {
    if (stop_()) return false;
    bent_dt_ *= 2;
    const double dt = std::min(longest_substep(to), bent_dt_);
    for (const int b : moved_) follow_motion(b);
    for (const int b : active_) body(b).motion = nullptr;
    near_ = &pairs_.find(t_, dt);
    roles_.choose(*near_, dt);
    if (bounce()) {
      while (bounce()) {
      }
      continue;
    }
    if (!move(dt)) result_.row.least_distance = -kInfinity;
  }
  return true;
}

// Newton's law at the points that touch and close: u_n after = -e u_n before, with friction. Points that do
// not close have no part in it: blows go on from body to body. False: none closes so fast that it rebounds.
bool GroupStepper::bounce() {
  bool any = false;
  std::vector<ContactUnknown> contacts;
  for (const NearPair& pair : *near_) {
    if (pair.contact.lower > scales_.touching()) continue;
    for (const GapPoint& point : pair.contact.points) {
      if (point.gap > scales_.touching()) continue;
      const double speed = roles_.approach(pair, point);
      if (!(speed > 0)) continue;
      const bool rebound = roles_.is_rebound(pair, speed);
      any = any || rebound;
      contacts.push_back({pair.a, pair.b, point.at, pair.contact.normal, point.gap,
                          rebound ? -*pair.law.restitution * speed : 0.0, pair.law.friction,
                          Eigen::Vector3d::Zero()});
    }
  }
  if (!any) return false;
  roles_.count_bounce();
  ++result_.row.impacts;
  ++counters_.impact_problems;
  save(free_);
  const double residual = problem_.solve(contacts, bodies_);
  if (problem_.jams()) {  // the substep will tell
    restore(free_);
    roles_.end_bounces();
    return false;
  }
  result_.row.residual = std::max(result_.row.residual, residual);
  std::vector<double> energies(free_.size());
  for (const int b : active_)
    energies[static_cast<std::size_t>(b)] = free_[static_cast<std::size_t>(b)].kinetic_energy();
  limit_energy(contacts, std::move(energies));
  record_contacts(contacts, true);
  return true;
}

// One substep of at most dt, shorter where the proof ends; false: its end could not be proven.
bool GroupStepper::move(double dt) {
  const double asked = dt;
  problem_.forget();
  save(before_);
  for (int trial = 0; trial < kMostTrials; ++trial) {
    restore(before_);
    if (stop_()) return true;  // nothing was done
    if (!settle(dt)) {
      dt /= 2;
      restore(before_);
      if (problem_.jams() && dt < kShortest * dynamics_.step)
        refuse_jam(problem_.jammed(), bodies_, parts_, t_);
      if (problem_.jams()) bent_dt_ = dt;
      roles_.choose(*near_, dt);  // what was asked of the longer one is no longer
      continue;
    }
    const double end = end_of(dt);
    const double proven = dynamics_.contact ? pairs_.proven_until(t_, end) : end;
    if (proven >= end) {
      if (!pairs_.nothing_touched())
        result_.row.least_distance = std::min(result_.row.least_distance, -scales_.delta);
      commit(end);
      return true;
    }
    if (trial < kMostJoins && join_late(pairs_.ended_proof())) continue;
    dt = shorter_than(dt, proven - t_, trial);
    if (dt == 0) break;
    restore(before_);
    roles_.choose(*near_, dt);
  }
  if (problem_.jams()) refuse_jam(problem_.jammed(), bodies_, parts_, t_);
  move_unproven(std::min(asked, kUnproven * dynamics_.step));
  return false;
}

// The impulses and motions over dt, with all pairs that they bring together, first of them roughly. What
// bends is corrected by a solution alone: it would rise for one that is off. False: see push_and_move().
bool GroupStepper::settle(double dt) {
  int corrections = 0;
  const auto bends = [&] {
    return !problem_.is_rough() && corrections < kMostCorrections && ++corrections > 0 && corrected(dt);
  };
  for (const bool roughly : {true, false}) {
    if (!push_and_move(dt, roughly)) return false;
    while (catch_closing(dt) || bends()) {
      restore(before_);
      if (!push_and_move(dt, roughly)) return false;
    }
    if (!problem_.is_rough()) return true;
    restore(before_);
  }
  return true;
}

void GroupStepper::move_unproven(double dt) {
  bent_dt_ = kInfinity;
  restore(before_);
  for (int trial = 0; !push_and_move(dt, false); ++trial) {
    if (trial == kMostTrials && problem_.jams()) refuse_jam(problem_.jammed(), bodies_, parts_, t_);
    if (trial == kMostTrials)
      throw Error("simulation: at " + std::to_string(t_) + " s a body spins too fast");
    dt /= 2;
    restore(before_);
  }
  commit(end_of(dt));
}

// The substep after one of dt, of which so much was proven; 0: no shorter one makes progress.
double GroupStepper::shorter_than(double dt, double proven, int trial) {
  const double shortest = kShortest * dynamics_.step;
  const NearPair* const pair = pairs_.ended_proof();
  const bool bends = pair != nullptr && pair->role == PairRole::contact;
  if (bends && proven < kBent * dt && dt > shortest) return bent_dt_ = kBent * dt;
  if (proven < shortest) return 0;
  return trial < 3 ? proven : std::min(proven, dt / 2);
}

double GroupStepper::end_of(double dt) const {
  const double end = t_ + dt;
  return end_of_step_ - end < 1e-12 * dynamics_.step ? end_of_step_ : end;
}

}  // namespace raygauge
