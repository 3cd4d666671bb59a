// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/extrapolation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace raygauge::test_extrapolation {
namespace {

// r -> M r + b, of which plain steps would gain a digit in 45: the extrapolation knows all of it after as
// many steps as it has dimensions.
TEST(Extrapolation, fixed_points_of_affine_maps_are_found) {
  for (const Eigen::Index n : {1, 3, 6}) {
    const Eigen::MatrixXd random = Eigen::MatrixXd::Random(n, n);
    const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(random).householderQ();
    const Eigen::VectorXd rates = Eigen::VectorXd::LinSpaced(n, 0.95, 0.3), b = Eigen::VectorXd::Random(n);
    const Eigen::MatrixXd M = Q * rates.asDiagonal() * Q.transpose();
    const Eigen::VectorXd wanted = (Eigen::MatrixXd::Identity(n, n) - M).inverse() * b;
    Extrapolation extrapolation(n);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(n);
    for (Eigen::Index k = 0; k < n + 1; ++k) {
      const Eigen::VectorXd g = M * r + b;
      extrapolation.next(g - r, g, r);
    }
    EXPECT_LE((r - wanted).norm(), 1e-6 * wanted.norm()) << n;
  }
}

// More steps than it remembers, in more dimensions; and after forget() it learns anew.
TEST(Extrapolation, steps_beyond_the_memory_go_on) {
  const Eigen::Index n = 40;
  const Eigen::VectorXd rates = Eigen::VectorXd::LinSpaced(n, 0.97, 0.1), b = Eigen::VectorXd::Ones(n);
  const Eigen::VectorXd wanted = b.cwiseQuotient(Eigen::VectorXd::Ones(n) - rates);
  Extrapolation extrapolation(n);
  for (int begin = 0; begin < 2; ++begin) {
    extrapolation.forget();
    Eigen::VectorXd r = Eigen::VectorXd::Zero(n);
    for (int k = 0; k < 80; ++k) {
      const Eigen::VectorXd g = rates.cwiseProduct(r) + b;
      extrapolation.next(g - r, g, r);
    }
    EXPECT_LE((r - wanted).norm(), 1e-6 * wanted.norm());  // plain steps: 0.09
  }
}

// Changes that say nothing new divide by nothing.
TEST(Extrapolation, equal_changes_leave_finite_numbers) {
  Extrapolation extrapolation(2);
  const Eigen::Vector2d f(1, 2), g(3, 4);
  Eigen::VectorXd r(2);
  for (int k = 0; k < 20; ++k) {
    extrapolation.next(f, g, r);
    EXPECT_EQ(r, g);
  }
}

}  // namespace
}  // namespace raygauge::test_extrapolation
