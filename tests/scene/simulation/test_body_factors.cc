// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/body_factors.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_body_factors {
namespace {

// 1 + Σ G D Gᵀ as Newton's method has it, D the larger the closer to `stiffness`, not symmetric.
TEST(BodyFactors, solutions_are_those_of_the_dense_matrix) {
  small_islands::Random random(11);
  for (const double stiffness : {1.0, 1e6}) {
    const FrictionIsland island = small_islands::heap(25, 70, 0.5, random);
    BodyFactors factors(island);
    for (int repeat = 0; repeat < 2; ++repeat) {
      factors.set_identity();
      Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(150, 150);
      for (const IslandContact& contact : island.contacts) {
        Eigen::Matrix3d D = stiffness * Eigen::Matrix3d::Identity();
        D(1, 0) = -0.5 * stiffness * small_islands::some(random);
        factors.add(contact, factors.places_of(contact), D);
        Eigen::MatrixXd G = Eigen::MatrixXd::Zero(150, 3);
        if (contact.a >= 0) G.middleRows(6L * contact.a, 6) = contact.A_a;
        if (contact.b >= 0) G.middleRows(6L * contact.b, 6) = contact.A_b;
        dense += G * D * G.transpose();
      }
      const Eigen::VectorXd wanted = Eigen::VectorXd::Random(150), b = dense * wanted;
      BodyColumns x = b.reshaped(6, 25);
      factors.factorize();
      factors.solve(x);
      EXPECT_LE((dense * x.reshaped() - b).norm(), 1e-13 * dense.norm() * wanted.norm());
      EXPECT_LE((x.reshaped() - wanted).norm(), 1e-12 * stiffness * wanted.norm());
    }
  }
}

}  // namespace
}  // namespace raygauge::test_body_factors
