// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/body_factors.h"
#include "scene/simulation/friction_island.h"

namespace raygauge {

/// Interior points for the contacts of an island, from nothing: the number of steps grows little with that of
/// the contacts, and where Newton's method for the law itself circles, they come near all the same. In the
/// unknowns
///
///     x = (r_n, r_t / μ),     z = (u_n + μ |u_t|, μ u_t),
///
/// which both lie in the cone of x_n >= |x_t|, the law is x · z = 0. A step is Newton's for x ∘ z = σ τ e and
/// u = W r + q, with τ the mean of x · z, ∘ the product of Jordan's algebra of the cone, the scaling of
/// Nesterov and Todd (1997) and Mehrotra's (1992) choice of σ; μ |u_t| takes part in it (Acary, Armand,
/// Nguyen and Shpakovych 2024). With the slopes G of the contacts, D = diag(1, μ, μ), P the scaling of a
/// contact and b the slope of |z_t|,
///
///     δx = P⁻¹ρ - P⁻² δz,     δz = (1 + e bᵀ) (D Σ Gᵀ δy - lack),
///     (1 + Σ G D P⁻² (1 + e bᵀ) D Gᵀ) δy = Σ G D (P⁻¹ρ + P⁻² (1 + e bᵀ) lack):
///
/// a system of the bodies' velocities as that of IslandNewton. Contacts that neither press nor part keep it
/// from coming nearer than about 1e-5; what it leaves to do is Newton's.
class IslandInterior {
 public:
  /// `bound`: of ‖W‖.
  IslandInterior(const FrictionIsland& island, double bound);

  /// Impulses of the least island_residual() on the way, which is returned in `r`; it ends at `enough`, or
  /// where no step comes nearer.
  double solve(double enough, Eigen::VectorXd& r);

 private:
  struct Cone {
    Eigen::Vector3d x, z, by_x, by_z;   // x and z, and what a step adds to them
    Eigen::Vector3d scaled, rho, lack;  // P x = P⁻¹ z, the right side of its equation, z - what r gives
    Eigen::Matrix3d P, P_inverse, by_lack;  // the last is P⁻² (1 + e bᵀ)
    BodyFactors::Places places{};
  };

  void begin();
  double measure();
  void scale();
  void find_step();
  double longest_step() const;
  double mean_after(double share) const;
  bool step();

  const FrictionIsland& island_;
  double bound_, size_of_q_;
  std::vector<Cone> cones_;
  Eigen::VectorXd r_;
  double mean_ = 0;  // τ
  IslandVelocities velocities_;
  BodyColumns y_;
  BodyFactors factors_;
};

}  // namespace raygauge
