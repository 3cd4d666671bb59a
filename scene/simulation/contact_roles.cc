// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_roles.h"

#include <algorithm>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr int kMostBounces = 200;  // at one moment; then bodies do not rebound any more
constexpr double kDeepest = 0.5;   // of δ: bodies as deep that leave each other are asked to, as in contact

}  // namespace

void ContactRoles::end_bounces() noexcept { bounces_ = kMostBounces + 1; }

// How fast a point of contact closes, now.
double ContactRoles::approach(const NearPair& pair, const GapPoint& point) const {
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  return -(a.velocity_at(point.at) - b.velocity_at(point.at)).dot(pair.contact.normal);
}

// The acceleration at which gravity presses them together.
double ContactRoles::pressing(const NearPair& pair) const {
  if (!dynamics_.gravity) return 0;
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  const double share = (a.reacts() ? 1.0 : 0.0) - (b.reacts() ? 1.0 : 0.0);
  return -share * dynamics_.gravity->dot(pair.contact.normal);
}

// A rebound is computed where it leads farther away than δ, before the bodies meet again or within a step.
bool ContactRoles::is_rebound(const NearPair& pair, double approach) const {
  const double speed = pair.law.restitution.value_or(0) * approach;
  if (!(speed > 0) || bounces_ > kMostBounces) return false;
  const double a = pressing(pair);
  return (a > 0 ? speed * speed / (2 * a) : speed * dynamics_.step) > scales_.delta;
}

double ContactRoles::closing_speed(const NearPair& pair) const {
  double fastest = -kInfinity;
  for (const GapPoint& point : pair.contact.points) fastest = std::max(fastest, approach(pair, point));
  return fastest;
}

// Bodies that meet within the substep and do not rebound are in contact from its beginning, with their gap:
// no point closes by more than that. So blows without rebound cut no substep.
PairRole ContactRoles::role_of(const NearPair& pair, double dt) const {
  const double fastest = pair.closing;
  const double a = std::max(pressing(pair), 0.0);
  if (pair.contact.lower <= scales_.touching()) {
    const bool deep = pair.contact.lower < -kDeepest * scales_.delta;
    return is_rebound(pair, -fastest) && !deep ? PairRole::leaving : PairRole::contact;
  }
  const bool meets = pair.contact.lower - dt * fastest - a * dt * dt <= 0;
  return meets && !is_rebound(pair, fastest + a * dt) ? PairRole::contact : PairRole::apart;
}

void ContactRoles::choose(std::vector<NearPair>& near, double dt) const {
  for (NearPair& pair : near) {
    pair.closing = closing_speed(pair);
    pair.role = role_of(pair, dt);
    pair.correction = 0;
  }
}

}  // namespace raygauge
