// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Second-order information and inner radii of every set, held to its support function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/sets/bounded_inverse.h"
#include "engine/sets/capability_queries.h"
#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_set_pieces {
namespace {

class Pieces : public testing::TestWithParam<SetCase> {
 protected:
  Pieces() : points_(n() * SupportPieces::kCapacity), hessians_(n() * n() * SupportPieces::kCapacity) {
    pieces_.dimension = n();
    pieces_.points = points_.data();
    pieces_.hessians = hessians_.data();
  }

  const ConvexSet& set() const { return *GetParam().set; }
  int n() const { return set().dimension(); }
  bool smooth() const {
    return set().structure() == SupportStructure::smooth || set().structure() == SupportStructure::point;
  }

  int evaluate(const Vector& u) {
    support_pieces(set(), u.data(), pieces_);
    return pieces_.count;
  }
  Vector point(int i) const { return Vector::Map(pieces_.point(i), n()); }
  Eigen::MatrixXd hessian(int i) const { return Eigen::MatrixXd::Map(pieces_.hessian(i), n(), n()); }

  Vector points_, hessians_;
  SupportPieces pieces_;
};

TEST_P(Pieces, AreBoundedByTheSupportFunctionWhichTheGreatestAttains) {
  if (!smooth()) return;
  Random random(61);
  for (int i = 0; i < 50; ++i) {
    const Vector u = gaussian_points(n(), 1, random);
    const double h = set().support_function(u);
    ASSERT_GE(evaluate(u), 1);
    double greatest = pieces_.value[0];
    for (int j = 0; j < pieces_.count; ++j) {
      const double value = pieces_.value[static_cast<std::size_t>(j)];
      EXPECT_NEAR(value, u.dot(point(j)), 1e-11) << "piece " << j;
      EXPECT_LE(GetParam().excess(point(j)), 1e-9) << "piece " << j;
      greatest = std::max(greatest, value);
    }
    EXPECT_NEAR(greatest, h, 1e-12 * (1 + std::fabs(h)));
  }
}

TEST_P(Pieces, HaveTheHessiansOfTheirGradients) {
  if (!smooth()) return;
  Random random(62);
  constexpr double step = 1e-5;
  constexpr double kNullDirection = 1e-8;  // rounding times q - 1 = 1e6, the most of any case
  for (int i = 0; i < 20; ++i) {
    const Vector u = sphere_points(n(), 1, random);
    const Vector d = sphere_points(n(), 1, random);
    const int count = evaluate(u);
    std::vector<Eigen::MatrixXd> H;
    for (int j = 0; j < count; ++j) H.push_back(hessian(j));
    // Near a component 0 the curvature of a p-norm is not that of its neighbourhood.
    if (u.cwiseAbs().minCoeff() < 0.05) continue;
    ASSERT_EQ(evaluate(u + step * d), count);
    std::vector<Vector> ahead;
    for (int j = 0; j < count; ++j) ahead.push_back(point(j));
    ASSERT_EQ(evaluate(u - step * d), count);
    for (int j = 0; j < count; ++j) {
      const Eigen::MatrixXd& H_j = H[static_cast<std::size_t>(j)];
      const Vector difference = (ahead[static_cast<std::size_t>(j)] - point(j)) / (2 * step);
      EXPECT_LT((H_j * d - difference).norm(), 1e-3 * (1 + H_j.norm())) << "piece " << j;
      EXPECT_LT((H_j * u).norm(), kNullDirection * (1 + H_j.norm())) << "piece " << j;
      EXPECT_LT((H_j - H_j.transpose()).norm(), 1e-12 * (1 + H_j.norm())) << "piece " << j;
    }
  }
}

TEST_P(Pieces, InnerBallLiesInTheSet) {
  Random random(63);
  const Vector center = set().center();
  for (int i = 0; i < 40; ++i) {
    const Vector c = i == 0 ? center : Vector(0.7 * center + 0.3 * GetParam().sample(random));
    const double radius = set().inner_radius_unchecked(c.data());
    ASSERT_GE(radius, 0);
    if (radius == 0) continue;
    for (int j = 0; j < 40; ++j) {
      const Vector u = sphere_points(n(), 1, random);
      EXPECT_LE(u.dot(c) + radius, set().support_function(u) + 1e-13 * (1 + c.norm()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, Pieces, testing::ValuesIn(set_cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(BoundedInverse, NeverOverstatesTheLeastStretch) {
  Random random(64);
  for (const int n : {1, 2, 3, 8}) {
    for (const double smallest : {1.0, 1e-3, 1e-8}) {
      Vector axes = Vector::Ones(n);
      axes[0] = smallest;
      const Eigen::MatrixXd L = random_rotation(n, random) * axes.asDiagonal() * random_rotation(n, random);
      const BoundedInverse inverse(L);
      EXPECT_LE(inverse.least_stretch(), smallest * (1 + 1e-7));
      EXPECT_GE(inverse.least_stretch(), smallest / std::sqrt(n) * 0.99);
      const Vector v = gaussian_points(n, 1, random);
      const Vector image = L * v;
      const Vector zero = Vector::Zero(n);
      EXPECT_GE(inverse.image_length(image.data(), zero.data()), v.norm() * (1 - 1e-14));
    }
  }
}

TEST(BoundedInverse, ProvesNothingOfASingularOrOblongMatrix) {
  EXPECT_EQ(BoundedInverse(Eigen::MatrixXd::Zero(3, 3)).least_stretch(), 0);
  EXPECT_EQ(BoundedInverse(Eigen::MatrixXd::Ones(3, 2)).least_stretch(), 0);
  EXPECT_EQ(BoundedInverse(Eigen::MatrixXd::Ones(3, 3)).least_stretch(), 0);
}

}  // namespace
}  // namespace raygauge::test_set_pieces
