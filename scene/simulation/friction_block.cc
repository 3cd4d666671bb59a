// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_block.h"

#include <algorithm>
#include <utility>

#include "scene/simulation/friction_ladder.h"
#include "scene/simulation/friction_newton.h"
#include "scene/simulation/friction_passes.h"

namespace raygauge {
namespace {

Eigen::Index row_of(std::size_t contact) { return 3 * static_cast<Eigen::Index>(contact); }

}  // namespace

FrictionBlock::FrictionBlock(const FrictionIsland& island, std::set<int> bodies)
    : bodies_(std::move(bodies)) {
  FrictionIsland own;
  own.bodies = island.bodies;
  for (std::size_t c = 0; c < island.contacts.size(); ++c) {
    const IslandContact& contact = island.contacts[c];
    if (bodies_.count(contact.a) == 0 && bodies_.count(contact.b) == 0) continue;
    contacts_.push_back(c);
    own.contacts.push_back(contact);
  }
  problem_ = own.dense();
}

bool FrictionBlock::has(std::size_t contact) const {
  return !lost_ && std::binary_search(contacts_.begin(), contacts_.end(), contact);
}

void FrictionBlock::solve(const FrictionIsland& island, IslandVelocities& velocities, Eigen::VectorXd& r) {
  if (lost_) return;
  Eigen::VectorXd before(problem_.q.size()), u(problem_.q.size());
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    before.segment<3>(row_of(k)) = r.segment<3>(row_of(contacts_[k]));
    u.segment<3>(row_of(k)) = velocities.of(island.contacts[contacts_[k]]);
  }
  problem_.q = u - problem_.W * before;
  Eigen::VectorXd after = before;
  double residual = improve_friction(problem_, after, 0);
  if (residual > kSolvedFriction && paths_-- > 0)
    residual = stiffen_contacts(problem_, before, residual, after);
  lost_ = is_new_ && residual > kSolvedFriction;
  is_new_ = false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    velocities.push(island.contacts[contacts_[k]], (after - before).segment<3>(row_of(k)));
    r.segment<3>(row_of(contacts_[k])) = after.segment<3>(row_of(k));
  }
}

}  // namespace raygauge
