// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/certified_bounds.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "raygauge/exceptions.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_certified_bounds {
namespace {

using Indices = std::vector<std::ptrdiff_t>;
using Weights = std::vector<double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CertifiedLower, IsBelowTheExactQuotientForAnyDirection) {
  Random random(51);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + trial % 6;
    const double scale = std::ldexp(1.0, 100 * (trial % 7) - 300);
    const Eigen::MatrixXd a = scale * (sphere_points(n, 20, random).colwise() + 3 * Vector::Unit(n, 0));
    const Eigen::MatrixXd q = gaussian_points(n, 20, random);
    const Vector u = -Vector::Unit(n, 0) + 0.3 * gaussian_points(n, 1, random);
    const double lower = certified_lower(PointSet(a), PointSet(q), u.data());
    const Rational h_A = exact_support(a, u);
    const Rational h_Q = exact_support(q, -u);
    if (h_A >= 0) {
      EXPECT_EQ(lower, 0);
    } else if (h_Q > 0) {
      EXPECT_TRUE(encloses(lower, kInfinity, -h_A / h_Q));
      EXPECT_LT(lower, kInfinity);
    }
  }
}

TEST(CertifiedLower, IsInfiniteForAFarkasDirection) {
  Eigen::MatrixXd q(2, 3);
  q << 0, 0, 2, 1, -1, 0;
  const PointSet A((Vector(2) << -1e-9, 0.5).finished());
  const Vector u = Vector::Unit(2, 0);
  EXPECT_EQ(certified_lower(A, PointSet(q), u.data()), kInfinity);
}

TEST(CertifiedLower, ProvesNothingFromADirectionThatDoesNotSeparate) {
  const PointSet A(cube_vertices(2));
  const Vector u = Vector::Unit(2, 0);
  EXPECT_EQ(certified_lower(A, PointSet(cube_vertices(2)), u.data()), 0);
  EXPECT_EQ(certified_lower(A, PointSet(cube_vertices(2)), Vector::Zero(2).eval().data()), 0);
}

class PointAgainstTheCrossPolytope : public ::testing::Test {
 protected:
  // (3, -1) = 3 e_1 + 1 (-e_2): distance 4, carried by vertices 0 and 3.
  PointSet A_{(Vector(2) << 3, -1).finished()};
  PointSet Q_{cross_polytope_vertices(2)};
};

TEST_F(PointAgainstTheCrossPolytope, IsBoundedByThePointsThatCarryTheSolution) {
  const double upper = certified_upper(A_, Q_, Indices{0}, Weights{1}, Indices{0, 3}, Weights{3, 1});
  EXPECT_GE(upper, 4);
  EXPECT_LE(upper, 4 * (1 + 1e-14));
}

TEST_F(PointAgainstTheCrossPolytope, IsBoundedFromPoorWeightsToo) {
  const double upper = certified_upper(A_, Q_, Indices{0}, Weights{7}, Indices{0, 3, 1}, Weights{0.1, 1, 1});
  EXPECT_GE(upper, 4);
  EXPECT_LE(upper, 4 * (1 + 1e-14));
}

TEST_F(PointAgainstTheCrossPolytope, IsNotBoundedByPointsThatCannotCarryIt) {
  EXPECT_EQ(certified_upper(A_, Q_, Indices{0}, Weights{1}, Indices{1, 2}, Weights{3, 1}), kInfinity);
}

TEST_F(PointAgainstTheCrossPolytope, RefusesIndicesOutsideTheSetsAndSpansOfDifferentLengths) {
  EXPECT_THROW(certified_upper(A_, Q_, Indices{1}, Weights{1}, Indices{0, 3}, Weights{3, 1}),
               InvalidParameterError);
  EXPECT_THROW(certified_upper(A_, Q_, Indices{0}, Weights{1}, Indices{0, 4}, Weights{3, 1}),
               InvalidParameterError);
  EXPECT_THROW(certified_upper(A_, Q_, Indices{0}, Weights{1}, Indices{0, -1}, Weights{3, 1}),
               InvalidParameterError);
  EXPECT_THROW(certified_upper(A_, Q_, Indices{0}, Weights{1}, Indices{0, 3}, Weights{3}),
               InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_certified_bounds
