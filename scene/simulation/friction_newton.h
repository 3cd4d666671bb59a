// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/body_factors.h"
#include "scene/simulation/friction_island.h"
#include "scene/simulation/tuning.h"

namespace raygauge {

/// Newton's method for the contacts of an island, on the equations of Alart and Curnier (1991),
///
///     r_n = a,  a = max(0, r_n - ρ u_n),     r_t = the point of the disc of radius μ a nearest to r_t - ρ
///     u_t,
///
/// where u has κ (r - p) more: contacts are soft about impulses p. With what the equations lack, F, their
/// slopes A by r and B by u, and the slopes G of the contacts, a step is
///
///     δr = -(A + κ B)⁻¹ (F + B Σ Gᵀδy),     (1 + Σ G (A + κ B)⁻¹ B Gᵀ) δy = -Σ G (A + κ B)⁻¹ F:
///
/// a system of the bodies' scaled velocities y, whose matrix has few blocks.
///
/// p is where the round before has ended (proximal points, Rockafellar 1976), so that the rounds lead to an
/// end of stiff contacts. Soft ones have one solution near p also where stiff ones share at will what they
/// carry, or where their impulses grow until one slips. κ falls while rounds end soon, and rises where they
/// do not.
class IslandNewton {
 public:
  /// `bound`: of ‖W‖.
  IslandNewton(const FrictionIsland& island, double bound);

  /// From r to the best that was seen, until its island_residual() is `enough` and falls no longer, or has
  /// not fallen to half within so many rounds. Returns it; it is never above that of r. ρ is `steepness`/‖W
  /// of the contact‖: where it is large, bodies that slip by little are told from such that stick. Contacts
  /// are the stiffer at first the nearer r is.
  double improve(double steepness, double enough, Eigen::VectorXd& r,
                 int patience = tuned::kPatienceOfRounds);

 private:
  struct Row {
    double size = 0;  // ‖W of the contact‖
    Eigen::Vector3d u, F;
    Eigen::Vector3d by_step;        // what a step adds to u
    Eigen::Matrix3d inverse, by_y;  // (A + κ B)⁻¹ and that times B
    BodyFactors::Places places{};
  };

  double look(const Eigen::VectorXd& r);
  double after(double share, const Eigen::VectorXd& r) const;
  inline Eigen::Vector3d lacks(std::size_t c, const Eigen::Vector3d& r, const Eigen::Vector3d& u) const;
  void take_slope(std::size_t c, const Eigen::Vector3d& r);
  void find_step(const Eigen::VectorXd& r);
  int solve_soft(Eigen::VectorXd& r);

  const FrictionIsland& island_;
  double bound_, size_of_q_;
  double largest_ = 0;  // number on the diagonal of W
  double softness_ = 0, steepness_ = 1;
  int stuck_ = 0;  // rounds since the last step
  Eigen::VectorXd anchor_, step_;
  std::vector<Row> rows_;
  IslandVelocities velocities_;
  BodyColumns y_;
  BodyFactors factors_;
};

}  // namespace raygauge
