// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/body_factors.h"
#include "scene/simulation/friction_island.h"

namespace raygauge {

/// Newton's method for the contacts of an island, on the equations of Alart and Curnier (1991), with ρ = 1/‖W
/// of the contact‖ and then 1e4 times that, by which bodies that slip by little are told from such that
/// stick:
///
///     r_n = a,  a = max(0, r_n - ρ u_n),     r_t = the point of the disc of radius μ a nearest to r_t - ρ
///     u_t.
///
/// With what they lack, F, their slopes A by r and B by u, and the slopes G of the contacts, a step is
///
///     δr = -(A + ε B)⁻¹ (F + B Σ Gᵀδy),     (1 + Σ G (A + ε B)⁻¹ B Gᵀ) δy = -Σ G (A + ε B)⁻¹ F,
///
/// ε = 1e-9 of W: a system of the bodies' scaled velocities y, whose matrix has few blocks. From a first
/// guess r that knows which contacts stick, slide and open it ends in a few steps; steps that do not come
/// closer end it.
class IslandNewton {
 public:
  /// `bound`: of ‖W‖. Of a contact, q may change between calls.
  IslandNewton(const FrictionIsland& island, double bound);

  /// From r to the best that was seen. Returns its island_residual(), which is never above that of r.
  double improve(Eigen::VectorXd& r) { return improve(0, r); }

  /// Newton's method from the end of a path of softer problems that begins at `start`: W + ε 1 with ε that
  /// falls from 1e-2 to nothing, relative to W. Where bodies stick at points that their gaps would move apart
  /// or together, impulses between these grow until one slips; soft contacts have bounded ones, and so the
  /// path tells which. `residual` is that of r, which is replaced where the end is better. Returns its
  /// residual.
  double stiffen(const Eigen::VectorXd& start, double residual, Eigen::VectorXd& r);

 private:
  struct Row {
    double rho = 0;  // 1/‖W of the contact‖
    Eigen::Vector3d u, F;
    Eigen::Matrix3d inverse, by_y;  // (A + ε B)⁻¹ and that times B
  };

  double improve(double softness, Eigen::VectorXd& r);  // of W + softness 1
  double look(const Eigen::VectorXd& r);
  void look_at(std::size_t c, const Eigen::Vector3d& r);
  void take_slope(std::size_t c, const Eigen::Vector3d& r);
  double residual(const Eigen::VectorXd& r) const;
  Eigen::VectorXd step(const Eigen::VectorXd& r);
  double descend(double factor, double best, Eigen::VectorXd& r);

  const FrictionIsland& island_;
  double bound_;
  double size_of_q_ = 0;
  double largest_ = 0;  // number on the diagonal of W
  std::vector<Row> rows_;
  IslandVelocities velocities_;
  BodyFactors factors_;
  double softness_ = 0, factor_ = 1;
};

}  // namespace raygauge
