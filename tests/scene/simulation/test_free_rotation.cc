// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/free_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace raygauge::test_free_rotation {
namespace {

const Eigen::Vector3d kMoments(1, 2, 3.5);

Rotor rotor() {
  Rotor rotor;
  rotor.J = kMoments.asDiagonal();
  rotor.J_inverse = kMoments.cwiseInverse().asDiagonal();
  return rotor;
}

// Turns for the time T in steps of h, near the unstable axis.
Eigen::Matrix3d turned(double T, int steps, const Eigen::Vector3d& L, double* energy = nullptr) {
  const Rotor body = rotor();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (int k = 0; k < steps; ++k) {
    const Eigen::Vector3d spin = *constant_spin(body, R, L, T / steps);
    R = Eigen::AngleAxisd(spin.norm() * T / steps, spin.normalized()).toRotationMatrix() * R;
    R = R * (1.5 * Eigen::Matrix3d::Identity() - 0.5 * R.transpose() * R);
  }
  if (energy != nullptr) *energy = body.spin(R, L).dot(L) / 2;
  return R;
}

TEST(FreeRotation, halving_the_step_divides_the_error_by_four) {
  const Eigen::Vector3d L(0.1, 2, 0.2);
  const Eigen::Matrix3d exact = turned(5, 64000, L);
  const double coarse = (turned(5, 500, L) - exact).norm(), fine = (turned(5, 1000, L) - exact).norm();
  EXPECT_GT(coarse, 1e-7);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

// Through many flips about the unstable axis: L is an argument and stays; the energy stays to rounding.
TEST(FreeRotation, energy_stays_over_a_hundred_thousand_steps) {
  const Eigen::Vector3d L(0.01, 2, 0.02);
  const double before = rotor().spin(Eigen::Matrix3d::Identity(), L).dot(L) / 2;
  double after = 0;
  const Eigen::Matrix3d R = turned(5000, 100000, L, &after);
  EXPECT_NEAR(after, before, 1e-11 * before);
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(FreeRotation, a_turn_about_a_principal_axis_is_exact_for_any_step) {
  const Eigen::Vector3d L(0, 0, 35);  // 10 radians a second
  EXPECT_LE((*constant_spin(rotor(), Eigen::Matrix3d::Identity(), L, 2) - Eigen::Vector3d(0, 0, 10)).norm(),
            1e-14);
}

TEST(FreeRotation, steps_are_symmetric) {
  const Eigen::Vector3d L(0.5, 1, 0.7);
  const Rotor body = rotor();
  const Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d there = *constant_spin(body, R, L, 0.3);
  const Eigen::Matrix3d then = Eigen::AngleAxisd(0.3 * there.norm(), there.normalized()).toRotationMatrix();
  const Eigen::Vector3d back = *constant_spin(body, then, -L, 0.3);
  EXPECT_LE((there + back).norm(), 1e-14);
}

TEST(FreeRotation, too_long_a_step_is_refused) {
  EXPECT_FALSE(constant_spin(rotor(), Eigen::Matrix3d::Identity(), Eigen::Vector3d(1, 1, 1), 10));
}

}  // namespace
}  // namespace raygauge::test_free_rotation
