// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_island.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

const ContactSlope& slope_of(const IslandContact& contact, int body) {
  return contact.a == body ? contact.A_a : contact.A_b;
}

}  // namespace

double FrictionIsland::size_of_q() const {
  double square = 0;
  for (const IslandContact& contact : contacts) square += contact.q.squaredNorm();
  return std::sqrt(square);
}

// Of a symmetric matrix no eigenvalue is above the largest sum of norms of a row of blocks; a block is no
// larger than the norms of its two factors.
double FrictionIsland::bound_of_W() const {
  std::vector<double> norms(static_cast<std::size_t>(bodies), 0);
  for (const IslandContact& contact : contacts) {
    if (contact.a >= 0) norms[static_cast<std::size_t>(contact.a)] += contact.A_a.norm();
    if (contact.b >= 0) norms[static_cast<std::size_t>(contact.b)] += contact.A_b.norm();
  }
  double bound = 0;
  for (const IslandContact& contact : contacts) {
    double sum = 0;
    if (contact.a >= 0) sum += contact.A_a.norm() * norms[static_cast<std::size_t>(contact.a)];
    if (contact.b >= 0) sum += contact.A_b.norm() * norms[static_cast<std::size_t>(contact.b)];
    bound = std::max(bound, sum);
  }
  return bound;
}

double FrictionIsland::rounding_of_residual(double bound, const Eigen::VectorXd& r) const {
  const double size = size_of_q();
  return size > 0 ? 0x1p-52 * r.norm() * bound / size : 0.0;
}

FrictionProblem FrictionIsland::dense() const {
  const auto size = 3 * static_cast<Eigen::Index>(contacts.size());
  FrictionProblem problem{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd(size), {}};
  std::vector<std::vector<std::size_t>> touching(static_cast<std::size_t>(bodies));
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const IslandContact& contact = contacts[c];
    problem.q.segment<3>(3 * static_cast<Eigen::Index>(c)) = contact.q;
    problem.mu.push_back(contact.mu);
    for (const int body : {contact.a, contact.b}) {
      if (body < 0) continue;
      auto& others = touching[static_cast<std::size_t>(body)];
      others.push_back(c);
      for (const std::size_t d : others) {
        const auto row = 3 * static_cast<Eigen::Index>(c), column = 3 * static_cast<Eigen::Index>(d);
        const Eigen::Matrix3d block = slope_of(contact, body).transpose() * slope_of(contacts[d], body);
        problem.W.block<3, 3>(row, column) += block;
        if (c != d) problem.W.block<3, 3>(column, row) += block.transpose();
      }
    }
  }
  const double largest = problem.W.diagonal().maxCoeff();
  for (Eigen::Index k = 2; k < size; k += 3) {
    if (!(problem.W(k, k) > 0)) problem.W(k, k) = largest;
  }
  return problem;
}

void IslandVelocities::reset(const FrictionIsland& island, const Eigen::VectorXd& r) {
  y_.setZero(6, island.bodies);
  for (std::size_t c = 0; c < island.contacts.size(); ++c)
    push(island.contacts[c], r.segment<3>(3 * static_cast<Eigen::Index>(c)));
}

double island_residual(const FrictionIsland& island, double bound, const Eigen::VectorXd& r) {
  const double size = island.size_of_q();
  if (!(size > 0)) return r.norm();
  return island_residual(island, bound, size, IslandVelocities(island, r), r);
}

double island_residual(const FrictionIsland& island, double bound, double size_of_q,
                       const IslandVelocities& velocities, const Eigen::VectorXd& r) {
  const double s = step_of(bound);
  double square = 0;
  for (std::size_t c = 0; c < island.contacts.size(); ++c)
    square += law_error(island.contacts[c], velocities, s, r, c);
  return std::sqrt(square) / (s * size_of_q);
}

}  // namespace raygauge
