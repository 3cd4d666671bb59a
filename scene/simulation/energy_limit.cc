// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/energy_limit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace raygauge {
namespace {

constexpr double kRounding = 1e-12;  // of the energies

void blend(ContactUnknown& contact, const ContactUnknown& rest, double share) {
  contact.impulse = rest.impulse + share * (contact.impulse - rest.impulse);
}

std::set<std::size_t> bodies_of(const std::vector<std::size_t>& island,
                                const std::vector<ContactUnknown>& contacts) {
  std::set<std::size_t> bodies;
  for (const std::size_t c : island) {
    bodies.insert(static_cast<std::size_t>(contacts[c].a));
    bodies.insert(static_cast<std::size_t>(contacts[c].b));
  }
  return bodies;
}

}  // namespace

double EnergyLimit::gain(const std::vector<std::size_t>& island,
                         const std::vector<ContactUnknown>& contacts) const {
  std::map<int, SimulatedBody> after;
  double gain = 0;
  for (const std::size_t c : island) {
    const ContactUnknown& contact = contacts[c];
    for (const auto& [number, sign] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      const SimulatedBody& body = free_[static_cast<std::size_t>(number)];
      const Eigen::Vector3d impulse = sign * contact.impulse;
      if (body.reacts())
        after.emplace(number, body).first->second.push(impulse, contact.at);
      else
        gain += impulse.dot(body.velocity_at(contact.at));
    }
  }
  for (const auto& [number, body] : after)
    gain += body.kinetic_energy() - allowed_[static_cast<std::size_t>(number)];
  return gain;
}

double EnergyLimit::slack(const std::vector<std::size_t>& island,
                          const std::vector<ContactUnknown>& contacts) const {
  double energies = 0;
  for (const std::size_t b : bodies_of(island, contacts)) energies += free_[b].kinetic_energy();
  return kRounding * energies;
}

std::vector<std::size_t> EnergyLimit::broken(const std::vector<ContactUnknown>& contacts) const {
  std::vector<std::size_t> all;
  for (const std::vector<std::size_t>& island : islands_of(contacts, free_)) {
    if (gain(island, contacts) > slack(island, contacts)) all.insert(all.end(), island.begin(), island.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// The gain is a quadratic of the share: that of 0, 1/2 and 1 give it.
double EnergyLimit::share(const std::vector<std::size_t>& island, const std::vector<ContactUnknown>& contacts,
                          const std::vector<ContactUnknown>& rest) const {
  const double last = gain(island, contacts), first = gain(island, rest);
  if (last <= slack(island, contacts)) return 1;
  if (first >= 0) return 0;
  std::vector<ContactUnknown> middle = contacts;
  for (const std::size_t c : island) blend(middle[c], rest[c], 0.5);
  const double half = gain(island, middle);
  const double a = 2 * (last + first - 2 * half), b = last - first - a;
  return std::min(1.0, -2 * first / (b + std::sqrt(b * b - 4 * a * first)));
}

void EnergyLimit::keep(std::vector<ContactUnknown>& contacts, const std::vector<ContactUnknown>& rest) const {
  for (const std::vector<std::size_t>& island : islands_of(contacts, free_)) {
    const double share = this->share(island, contacts, rest);
    for (const std::size_t c : island) blend(contacts[c], rest[c], share);
  }
}

void EnergyLimit::slow_down(const std::vector<ContactUnknown>& contacts,
                            std::vector<SimulatedBody>& pushed) const {
  for (const std::vector<std::size_t>& island : islands_of(contacts, free_)) {
    const double gain = this->gain(island, contacts);
    const std::set<std::size_t> bodies = bodies_of(island, contacts);
    if (!(gain > slack(island, contacts)) || !touches_what_stands(bodies)) continue;
    double kinetic = 0;
    for (const std::size_t b : bodies) kinetic += pushed[b].kinetic_energy();
    const double factor = std::sqrt(std::max(0.0, 1 - gain / kinetic));
    for (const std::size_t b : bodies) pushed[b].scale_velocities(factor);  // what stands has none
  }
}

// Nothing that is driven, and something that stands.
bool EnergyLimit::touches_what_stands(const std::set<std::size_t>& bodies) const {
  bool stands = false;
  for (const std::size_t b : bodies) {
    if (free_[b].reacts()) continue;
    if (!(free_[b].v.isZero(0) && free_[b].spin.isZero(0))) return false;
    stands = true;
  }
  return stands;
}

}  // namespace raygauge
