// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "scene/simulation/friction_island.h"

/// Islands to try friction on.
namespace raygauge::small_islands {

using Random = std::mt19937;

inline double some(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

inline Eigen::VectorXd zeros(const FrictionIsland& island) {
  return Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(island.contacts.size()));
}

/// Of one body or two: u = J y + q, three rows of J for each contact and six columns for each body.
inline FrictionIsland island_of(const Eigen::MatrixXd& J, const Eigen::VectorXd& q, double mu) {
  FrictionIsland island;
  island.bodies = static_cast<int>(J.cols() / 6);
  for (Eigen::Index at = 0; at < q.size(); at += 3) {
    IslandContact& contact = island.contacts.emplace_back();
    contact.a = 0;
    contact.A_a = J.block<3, 6>(at, 0).transpose();
    if (island.bodies > 1) {
      contact.b = 1;
      contact.A_b = J.block<3, 6>(at, 6).transpose();
    }
    contact.q = q.segment<3>(at);
    contact.mu = mu;
  }
  return island;
}

inline ContactSlope random_slope(Random& random) {
  ContactSlope A;
  for (Eigen::Index k = 0; k < A.size(); ++k) A.data()[k] = some(random);
  return A;
}

/// The first contact of each body is with the ground, others are with another body. All close.
inline FrictionIsland heap(int bodies, int contacts, double mu, Random& random) {
  FrictionIsland island;
  island.bodies = bodies;
  for (int c = 0; c < contacts; ++c) {
    IslandContact& one = island.contacts.emplace_back();
    one.a = c % bodies;
    one.A_a = random_slope(random);
    if (c >= bodies) {
      one.b = (one.a + 1 + c / bodies) % bodies;
      one.A_b = random_slope(random);
    }
    one.q = {-0.5 + some(random) / 3, some(random), some(random)};
    one.mu = mu;
  }
  return island;
}

}  // namespace raygauge::small_islands
