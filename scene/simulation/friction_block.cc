// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_block.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scene/simulation/friction_passes.h"

namespace raygauge {
namespace {

Eigen::Index row_of(std::size_t contact) { return 3 * static_cast<Eigen::Index>(contact); }

bool belongs(const IslandContact& contact, const std::set<int>& bodies) {
  return bodies.count(contact.a) != 0 || bodies.count(contact.b) != 0;
}

// The contacts of these bodies, those that they touch numbered anew.
FrictionIsland part_of(const FrictionIsland& island, const std::set<int>& bodies) {
  FrictionIsland own;
  std::map<int, int> numbers = {{-1, -1}};
  for (const IslandContact& contact : island.contacts) {
    if (!belongs(contact, bodies)) continue;
    IslandContact& one = own.contacts.emplace_back(contact);
    for (int* const body : {&one.a, &one.b}) {
      const auto [place, is_new] = numbers.emplace(*body, own.bodies);
      own.bodies += is_new ? 1 : 0;
      *body = place->second;
    }
  }
  return own;
}

}  // namespace

FrictionBlock::FrictionBlock(const FrictionIsland& island, std::set<int> bodies)
    : bodies_(std::move(bodies)), own_(part_of(island, bodies_)), newton_(own_, own_.bound_of_W()) {
  for (std::size_t c = 0; c < island.contacts.size(); ++c) {
    if (belongs(island.contacts[c], bodies_)) contacts_.push_back(c);
  }
}

bool FrictionBlock::has(std::size_t contact) const {
  return !lost_ && std::binary_search(contacts_.begin(), contacts_.end(), contact);
}

void FrictionBlock::solve(const FrictionIsland& island, IslandVelocities& velocities, Eigen::VectorXd& r) {
  if (lost_) return;
  Eigen::VectorXd before(row_of(contacts_.size()));
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    before.segment<3>(row_of(k)) = r.segment<3>(row_of(contacts_[k]));
  const IslandVelocities by_own(own_, before);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    IslandContact& contact = own_.contacts[k];
    contact.q += velocities.of(island.contacts[contacts_[k]]) - by_own.of(contact);
  }
  Eigen::VectorXd after = before;
  double residual = newton_.improve(after);
  if (residual > kSolvedFriction && paths_-- > 0) residual = newton_.stiffen(before, residual, after);
  lost_ = is_new_ && residual > kSolvedFriction;
  is_new_ = false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    velocities.push(island.contacts[contacts_[k]], (after - before).segment<3>(row_of(k)));
    r.segment<3>(row_of(contacts_[k])) = after.segment<3>(row_of(k));
  }
}

}  // namespace raygauge
