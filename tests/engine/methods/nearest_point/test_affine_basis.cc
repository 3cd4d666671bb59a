// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/nearest_point/affine_basis.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <vector>

#include "tests/engine/instruction_sets.h"

namespace raygauge {
namespace {

Eigen::MatrixXd random_points(int n, int count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(n, count, [&] { return normal(random); });
}

// min |P x| with the weights of each side adding up to one, by the conditions of optimality.
Eigen::VectorXd weights_by_kkt(const Eigen::MatrixXd& P, const std::vector<int>& side) {
  const auto k = P.cols();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(k + 2, k + 2);
  K.topLeftCorner(k, k) = P.transpose() * P;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(k + 2);
  for (Eigen::Index i = 0; i < k; ++i)
    K(k + side[static_cast<std::size_t>(i)], i) = K(i, k + side[static_cast<std::size_t>(i)]) = 1;
  right.tail(2).setOnes();
  return K.fullPivLu().solve(right).head(k);
}

TEST(AffineBasis, FindsTheNearestPointOfAffineHullsAfterAdditionsAndRemovals) {
  std::mt19937 random(5);
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const int n : {3, 8, 21, 60}) {
      Eigen::MatrixXd P = random_points(n, n, random);
      P.row(0).array() += 4;
      AffineBasis basis;
      basis.begin(n, 2, 4.0, kernels_for(isa));
      std::vector<int> side, kept;
      for (int i = 0; i < n; ++i) {
        ASSERT_TRUE(basis.add(P.col(i).data(), i % 2));
        side.push_back(i % 2);
        kept.push_back(i);
      }
      while (kept.size() > 2) {
        Eigen::MatrixXd left(n, static_cast<Eigen::Index>(kept.size()));
        for (std::size_t i = 0; i < kept.size(); ++i) left.col(static_cast<Eigen::Index>(i)) = P.col(kept[i]);
        Eigen::VectorXd weights(left.cols()), v(n);
        ASSERT_TRUE(basis.solve(weights.data(), v.data()));
        EXPECT_LT((weights - weights_by_kkt(left, side)).norm(), 1e-8 * (1 + weights.norm()))
            << n << " " << kept.size();
        EXPECT_LT((v - left * weights).norm(), 1e-9 * (1 + weights.norm())) << n << " " << kept.size();
        const std::size_t out = kept.size() / 3 + (side[kept.size() / 3] == 0 && kept.size() == 3 ? 1 : 0);
        basis.remove(static_cast<int>(out));
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(out));
        side.erase(side.begin() + static_cast<std::ptrdiff_t>(out));
        if (std::count(side.begin(), side.end(), 0) == 0 || std::count(side.begin(), side.end(), 1) == 0)
          break;
      }
    }
  }
}

TEST(AffineBasis, RefusesAPointOfTheAffineHull) {
  AffineBasis basis;
  basis.begin(3, 1, 1.0, best_kernels());
  const Eigen::Vector3d p(1, 0, 0), q(0, 1, 0), middle(0.5, 0.5, 0), beyond(2, -1, 0), off(0, 0, 1);
  EXPECT_TRUE(basis.add(p.data(), 0));
  EXPECT_TRUE(basis.add(q.data(), 0));
  EXPECT_FALSE(basis.add(middle.data(), 0));
  EXPECT_FALSE(basis.add(beyond.data(), 0));
  EXPECT_FALSE(basis.add(p.data(), 0));
  EXPECT_TRUE(basis.add(off.data(), 0));
  EXPECT_EQ(basis.count(), 3);
}

}  // namespace
}  // namespace raygauge
