// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "raygauge/simulation.h"

namespace raygauge {

/// What a velocity of 6 numbers, scaled by the root of its body's mass matrix, adds to that of a contact.
using ContactSlope = Eigen::Matrix<double, 6, 3>;

/// A contact of an island: u = A_aᵀ y_a + A_bᵀ y_b + q, and the impulse r changes y_a by A_a r, y_b by A_b r.
struct IslandContact {
  int a = -1, b = -1;  ///< bodies of the island; -1: one that does not react
  ContactSlope A_a = ContactSlope::Zero(), A_b = ContactSlope::Zero();
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  double mu = 0;

  bool operator==(const IslandContact&) const = default;
};

/// The problem of FrictionProblem by its bodies: W has the blocks Σ A_cᵀ A_d over the bodies that the
/// contacts c and d share.
struct FrictionIsland {
  int bodies = 0;
  std::vector<IslandContact> contacts;

  double size_of_q() const;  ///< |q|

  /// At least ‖W‖.
  double bound_of_W() const;

  /// What island_residual() cannot tell from 0, with a bound of ‖W‖: of impulses that have grown without end
  /// it is 0.
  double rounding_of_residual(double bound, const Eigen::VectorXd& r) const;

  bool operator==(const FrictionIsland&) const = default;

  /// With numbers of some other problem in directions along which nothing moves: the third of the plane.
  FrictionProblem dense() const;
};

/// Six numbers of each body.
using BodyColumns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Adds A_a r and A_b r.
inline void push_bodies(const IslandContact& contact, const Eigen::Vector3d& r, BodyColumns& y) {
  if (contact.a >= 0) y.col(contact.a).noalias() += contact.A_a * r;
  if (contact.b >= 0) y.col(contact.b).noalias() += contact.A_b * r;
}

/// u + A_aᵀ y_a + A_bᵀ y_b.
inline Eigen::Vector3d with_bodies(const IslandContact& contact, Eigen::Vector3d u, const BodyColumns& y) {
  if (contact.a >= 0) u.noalias() += contact.A_a.transpose() * y.col(contact.a);
  if (contact.b >= 0) u.noalias() += contact.A_b.transpose() * y.col(contact.b);
  return u;
}

/// The scaled velocities of the bodies that the impulses give: Σ A r.
class IslandVelocities {
 public:
  IslandVelocities() = default;
  IslandVelocities(const FrictionIsland& island, const Eigen::VectorXd& r) { reset(island, r); }

  void reset(const FrictionIsland& island, const Eigen::VectorXd& r);

  Eigen::Vector3d of(const IslandContact& contact) const { return with_bodies(contact, contact.q, y_); }
  void push(const IslandContact& contact, const Eigen::Vector3d& r) { push_bodies(contact, r, y_); }

 private:
  BodyColumns y_;
};

/// How far r and the velocity u leave a contact from its law: the length of r - (its nearest point in the
/// cone of r - s u'), squared, with s = 1/‖W‖ and u' the velocity as in friction_residual().
inline double law_error(double mu, const Eigen::Vector3d& u, double s, const Eigen::Vector3d& r) {
  const Eigen::Vector3d changed(u[0] + mu * u.tail<2>().norm(), u[1], u[2]);
  return (r - nearest_in_cone(r - s * changed, mu)).squaredNorm();
}

/// The same of the contact c, where the velocities are known that all impulses r give.
inline double law_error(const IslandContact& contact, const IslandVelocities& velocities, double s,
                        const Eigen::VectorXd& r, std::size_t c) {
  return law_error(contact.mu, velocities.of(contact), s, r.segment<3>(3 * static_cast<Eigen::Index>(c)));
}

/// s of a bound on ‖W‖.
inline double step_of(double bound) { return bound > 0 ? 1 / bound : 1.0; }

/// friction_residual() with `bound` in place of ‖W‖, which it is not below: so neither is this residual.
double island_residual(const FrictionIsland& island, double bound, const Eigen::VectorXd& r);

/// The same where the velocities that r gives, and |q| > 0, are known.
double island_residual(const FrictionIsland& island, double bound, double size_of_q,
                       const IslandVelocities& velocities, const Eigen::VectorXd& r);

}  // namespace raygauge
