// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/simulation/energy_limit.h"
#include "scene/simulation/group_stepper.h"
#include "scene/simulation/piecewise_motion.h"

// The work of one substep: forces, impulses and motions, and how its end is corrected and kept.
namespace raygauge {
namespace {

constexpr double kDeep = 0.25;       // of δ: pairs end a step no deeper, where they did not begin it so
constexpr double kSag = 0.6;         // of δ: half way they are no deeper, or than where they began
constexpr double kStill = 1e-13;     // of its reach: a body that a push moves less stays where it is
constexpr double kSamePoint = 1e-2;  // of the reach of the first body: points of contact that are one
constexpr double kRecovered = 0.8;   // what is left of the depth of those that did
// Of δ, and of the smaller body: gaps below are 0. To close them an arch would wedge its stones in, and the
// points of a face would be asked for velocities that no rigid body has.
constexpr double kRounding = 1e-8, kRoundingOfReach = 0x1p-44;

// Made orthonormal again: what a turn by rounded numbers loses, squared.
Eigen::Matrix3d polished(const Eigen::Matrix3d& R) {
  return R * (1.5 * Eigen::Matrix3d::Identity() - 0.5 * R.transpose() * R);
}

Eigen::Matrix3d turn_of(const Eigen::Vector3d& angle) {
  const double size = angle.norm();
  if (!(size > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(size, angle / size).toRotationMatrix();
}

// Damping by the midpoint rule: v' = g - c v.
void accelerate(const Dynamics& dynamics, double dt, SimulatedBody& body, SimulationCounters& counters) {
  const Eigen::Vector3d g = dynamics.gravity.value_or(Eigen::Vector3d::Zero());
  if (!dynamics.damping) {
    body.v += dt * g;
    return;
  }
  ++counters.damped_velocities;
  const double c = dynamics.damping->linear * dt / 2, d = dynamics.damping->angular * dt / 2;
  body.v = ((1 - c) * body.v + dt * g) / (1 + c);
  body.L *= (1 - d) / (1 + d);
  body.spin = body.rotor.spin(body.R, body.L);
}

// A body that was pushed moves at its new velocity, one in flight on its parabola.
bool give_motion(SimulatedBody& body, const SimulatedBody& before, double t, double dt, bool pushed, int n) {
  TwistMotion::Rates rates;
  const Eigen::Vector3d L = pushed ? body.L : Eigen::Vector3d((before.L + body.L) / 2);
  const auto spin = n == 2 ? std::optional(Eigen::Vector3d(0, 0, L[2] / body.rotor.J(2, 2)))
                           : constant_spin(body.rotor, body.R, L, dt);
  if (!spin) return false;
  rates.spin = *spin;
  rates.velocity = SmallVector((pushed ? body.v : before.v).head(n));
  if (!pushed && body.v != before.v) rates.acceleration = SmallVector(((body.v - before.v) / dt).head(n));
  body.still = pushed && (rates.velocity.norm() + rates.spin.norm() * body.reach) * dt <= kStill * body.reach;
  if (body.still) {
    rates.velocity.setZero();
    rates.spin.setZero();
  }
  const Placement first{SmallMatrix(body.R.topLeftCorner(n, n)), SmallVector(body.x.head(n))};
  body.motion = std::make_shared<TwistMotion>(first, rates, t);
  body.piece = {t, first, rates};
  return true;
}

}  // namespace

// Forces, impulses, then the motions over dt. False where a body turns too far for
// one, or is jammed.
bool GroupStepper::push_and_move(double dt, bool roughly) {
  for (const int b : active_) accelerate(dynamics_, dt, body(b), counters_);
  save(free_);
  contacts_.clear();
  for (const NearPair& pair : *near_) {
    if (pair.role != PairRole::contact) continue;
    const double reach = std::min(body(pair.a).reach, body(pair.b).reach);
    const double rounding = std::max(kRounding * scales_.delta, kRoundingOfReach * reach);
    for (const GapPoint& point : pair.contact.points) {
      // An overlap is given the time of a whole step to go.
      const double gap = std::fabs(point.gap) < rounding ? 0 : point.gap;
      const double now = gap / (gap < 0 ? dynamics_.step : dt);
      contacts_.push_back({pair.a, pair.b, point.at, pair.contact.normal, point.gap,
                           now + pair.correction / dt, pair.law.friction,
                           last_.guess(pair, point, kSamePoint * body(pair.a).reach, dt)});
    }
  }
  residual_ = problem_.solve(contacts_, bodies_, roughly);
  if (problem_.jams()) return false;
  last_.remember(contacts_, dt);
  pushed_.assign(bodies_.size(), false);
  for (const ContactUnknown& contact : contacts_) {
    if (contact.impulse.isZero(0)) continue;
    pushed_[static_cast<std::size_t>(contact.a)] = pushed_[static_cast<std::size_t>(contact.b)] = true;
  }
  return std::all_of(active_.begin(), active_.end(), [&](int number) {
    const auto b = static_cast<std::size_t>(number);
    return give_motion(bodies_[b], before_[b], t_, dt, pushed_[b], n_);
  });
}

// Pairs that were thought to stay apart or to separate, but that the impulses of others close: they join the
// problem, unless they rebound. Bodies in flight may come back within the substep; the proof ends where they
// do.
bool GroupStepper::catch_closing(double dt) {
  bool any = false;
  for (NearPair& pair : *near_) {
    if (pair.role == PairRole::contact) continue;
    const bool flies =
        !pushed_[static_cast<std::size_t>(pair.a)] && !pushed_[static_cast<std::size_t>(pair.b)];
    const double closing = flies ? 0 : roles_.closing_speed(pair);
    if (!(closing > 0)) continue;
    const bool touches = pair.contact.lower <= scales_.touching();
    if (!touches && (pair.contact.lower > dt * closing || roles_.is_rebound(pair, closing))) continue;
    pair.role = PairRole::contact;
    any = true;
  }
  return any;
}

// Normals turn and faces roll: where bodies would end closer than the problem said, it asks for that much
// more.
bool GroupStepper::corrected(double dt) {
  std::vector<NearPair>& near = *near_;
  more_.assign(near.size(), 0);
  pairs_.for_each_near([&](std::size_t k, PairTools& tools) { more_[k] = correction(near[k], dt, tools); });
  bool any = false;
  for (std::size_t k = 0; k < near.size(); ++k) {
    near[k].correction += more_[k];
    any = any || more_[k] < 0;
  }
  return any;
}

// What a pair is to be asked for more, below 0. Its way bends: half way it is closer than at both ends by a
// quarter of what the end is off.
double GroupStepper::correction(const NearPair& pair, double dt, PairTools& tools) {
  if (pair.role != PairRole::contact) return 0;
  const SimulatedBody &a = body(pair.a), &b = body(pair.b);
  const double turn = std::max(a.spin.norm(), b.spin.norm()) * dt;
  const double reach = a.reach + b.reach;
  const double start = pair.contact.lower;
  const bool deep = start < -kDeep * scales_.delta;
  if (!deep && turn * turn * std::min(reach, 1e150) < kDeep / 2 * scales_.delta) return 0;
  // Deep ones are to end less deep, by what a whole step would do: no shorter one is to push harder.
  const double share = std::min(1.0, dt / dynamics_.step);
  const double least = std::min((1 - (1 - kRecovered) * share) * start, -kDeep * scales_.delta);
  const double asked = (1 - share) * std::min(start, 0.0) - pair.correction;
  const double deepest = std::min(-kSag * scales_.delta, start);  // half way
  // Rises with the distance at the end, so that any lower bound that asks for nothing is enough.
  const auto lacking = [&](double last) {
    const double sag = std::max(0.0, asked - last) / 4;
    const double for_sag = std::min(2 * (sag + deepest) - start, kDeep * scales_.delta);
    return last - std::max(least, for_sag);
  };
  if (lacking(pairs_.looks().between_planes_at(pair, end_of(dt))) >= 0) return 0;
  const double closer = lacking(pairs_.distance_at(pair, end_of(dt), tools));
  return closer < 0 ? closer - share * kDeep / 2 * scales_.delta : 0;
}

// What contacts ask for beyond rest gives bodies no energy above `allowed`; it does move them. False: it
// would not.
bool GroupStepper::limit_energy(std::vector<ContactUnknown>& contacts, std::vector<double> allowed) {
  const EnergyLimit limit(free_, std::move(allowed));
  const std::vector<std::size_t> broken = limit.broken(contacts);
  if (broken.empty()) return false;
  std::vector<ContactUnknown> asked;
  for (const std::size_t c : broken) {
    asked.push_back(contacts[c]);
    asked.back().offset = std::max(contacts[c].offset, 0.0);
  }
  copy_active(free_, limited_);
  result_.row.residual = std::max(result_.row.residual, problem_.solve(asked, limited_));
  std::vector<ContactUnknown> rest = contacts;
  for (std::size_t k = 0; k < broken.size(); ++k) rest[broken[k]] = asked[k];
  limit.keep(contacts, rest);
  copy_active(free_, limited_);
  for (const ContactUnknown& contact : contacts) push_apart(contact, limited_);
  limit.slow_down(contacts, limited_);
  for (const int b : active_) body(b).take_velocities(limited_[static_cast<std::size_t>(b)]);
  return true;
}

// Until the end of a substep a body may have what it had before, and the work of gravity on its way. Where
// that is less than its motion has, its angular momentum turns with it: so its energy stays.
void GroupStepper::limit_pushes(double end) {
  const bool pushes = std::any_of(contacts_.begin(), contacts_.end(), [](const ContactUnknown& contact) {
    return contact.offset < 0 && !contact.impulse.isZero(0);
  });
  if (!pushes) return;
  std::vector<double> allowed(bodies_.size());
  for (const int number : active_) {
    const auto b = static_cast<std::size_t>(number);
    allowed[b] = before_[b].kinetic_energy();
    if (!dynamics_.gravity) continue;
    const Eigen::Vector3d way = in_space(bodies_[b].motion->at(end).t) - before_[b].x;
    allowed[b] += before_[b].mass * dynamics_.gravity->dot(way);
  }
  if (!limit_energy(contacts_, std::move(allowed))) return;
  for (const int b : active_) {
    SimulatedBody& body = this->body(b);
    const auto spin = constant_spin(body.rotor, body.R, body.L, end - t_);
    if (!spin) continue;
    const Eigen::Matrix3d by_itself = turn_of(*spin * (end - t_)) * body.R;
    body.L = polished(in_space(body.motion->at(end).R)) * (by_itself.transpose() * body.L);
  }
}

void GroupStepper::commit(double end) {
  limit_pushes(end);
  ++result_.row.substeps;
  result_.row.contacts += static_cast<std::int64_t>(contacts_.size());
  result_.row.residual = std::max(result_.row.residual, residual_);
  record_contacts(contacts_, false);
  roles_.begin_moment();
  t_ = end;
  for (const int b : active_) {
    SimulatedBody& body = this->body(b);
    pieces_[static_cast<std::size_t>(b)].push_back(body.piece);
    if (body.still) continue;
    const Placement at = body.motion->at(t_);
    body.x = in_space(at.t);
    body.R = polished(in_space(at.R));
    body.spin = body.rotor.spin(body.R, body.L);
  }
}

void GroupStepper::record_contacts(const std::vector<ContactUnknown>& contacts, bool impact) {
  for (const ContactUnknown& contact : contacts) {
    if (contact.impulse.isZero(0)) continue;
    result_.contacts.push_back({number_, t_, contact.a, contact.b, impact, contact.at, contact.normal,
                                contact.gap, contact.impulse});
  }
}

}  // namespace raygauge
