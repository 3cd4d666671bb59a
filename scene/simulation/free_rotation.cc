// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/free_rotation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace raygauge {
namespace {

constexpr double kSteady = 1e-15;
constexpr double kFarthest = 1;  // radians a step
constexpr int kMostIterations = 50;

Eigen::Matrix3d hat(const Eigen::Vector3d& a) {
  Eigen::Matrix3d A;
  A << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return A;
}

// A step of Newton's method on P - Π - k P × J⁻¹P = 0.
Eigen::Vector3d improved(const Rotor& rotor, const Eigen::Vector3d& Pi, const Eigen::Vector3d& P, double k) {
  const Eigen::Vector3d omega = rotor.J_inverse * P;
  const Eigen::Vector3d residual = P - Pi - k * P.cross(omega);
  const Eigen::Matrix3d slope = Eigen::Matrix3d::Identity() - k * (hat(P) * rotor.J_inverse - hat(omega));
  return P - slope.partialPivLu().solve(residual);
}

}  // namespace

std::optional<Eigen::Vector3d> constant_spin(const Rotor& rotor, const Eigen::Matrix3d& R,
                                             const Eigen::Vector3d& L, double h) {
  const Eigen::Vector3d Pi = R.transpose() * L;
  const Eigen::Vector3d omega = rotor.J_inverse * Pi;
  if (Pi.cross(omega).norm() <= kSteady * Pi.norm() * omega.norm()) return R * omega;
  if (!(h * omega.norm() <= kFarthest)) return std::nullopt;
  Eigen::Vector3d P = Pi;
  for (int i = 0; i < kMostIterations; ++i) {
    const double speed = (rotor.J_inverse * P).norm();
    const Eigen::Vector3d next = improved(rotor, Pi, P, std::tan(h * speed / 2) / speed);
    const double change = (next - P).norm();
    P = next;
    if (change <= 2e-16 * Pi.norm()) break;
  }
  return R * (rotor.J_inverse * P);
}

}  // namespace raygauge
