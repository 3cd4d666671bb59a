// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

namespace raygauge {

/// A rigid body that turns freely.
struct Rotor {
  Eigen::Matrix3d J;          ///< inertia about the centre of mass, in the axes of the body
  Eigen::Matrix3d J_inverse;  ///< its inverse
  Eigen::Matrix3d root;       ///< J⁻¹ = root rootᵀ

  /// ω = R J⁻¹ Rᵀ L, in space.
  Eigen::Vector3d spin(const Eigen::Matrix3d& R, const Eigen::Vector3d& L) const {
    return R * (J_inverse * (R.transpose() * L));
  }
};

/// The constant angular velocity ω with which the body, turned by R and of angular momentum L (both in
/// space), turns for the time h. With Π = RᵀL the implicit midpoint rule
///
///     Π_m = Π + h'/2 Π_m × J⁻¹Π_m,     ω = R J⁻¹Π_m,     h' = 2 tan(h|ω|/2)/|ω|,
///
/// turns by the Cayley map of h' J⁻¹Π_m, which is a turn by h|ω|. L is kept as it is, the energy exactly, to
/// rounding; steps are symmetric and of second order, and exact about principal axes. (Austin, Krishnaprasad,
/// Wang 1993, with h' in place of h.) Empty: h|ω| > 1, too far for one step.
std::optional<Eigen::Vector3d> constant_spin(const Rotor& rotor, const Eigen::Matrix3d& R,
                                             const Eigen::Vector3d& L, double h);

}  // namespace raygauge
