// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Sets that are symmetric in every coordinate, and the extents of their faces.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/sets/capability_queries.h"
#include "engine/sets/posed_view.h"
#include "raygauge/numerics/quad.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_unconditional {
namespace {

constexpr std::array kExponents = {1.1, 2.0, 3.0, 100.0, 1e6, 1e19};

TEST(Unconditional, IsAPNormBall) {
  Random random(91);
  for (const double p : kExponents) {
    const Vector center = gaussian_points(4, 1, random), semi_axes{{1, 0.5, 2, 4}};
    const PNormBall ball(center, semi_axes, p);
    Vector extent(4);
    ASSERT_TRUE(is_unconditional(ball, extent.data())) << "p = " << p;
    const Vector u = gaussian_points(4, 1, random);
    const double about_center = ball.support_function(u) - u.dot(center);
    for (int k = 0; k < 4; ++k) {
      Vector reflected = u;
      reflected[k] = -u[k];
      EXPECT_NEAR(ball.support_function(reflected) - reflected.dot(center), about_center, 1e-13);
    }
  }
}

// ‖z‖_p = 1 stays so if z_k = 0 becomes e_k/w_k in every such coordinate: (e_k/w_k)^p is far below the
// rounding errors of Quad.
TEST(Unconditional, FacesReachAsFarAsNoOneSees) {
  for (const double p : kExponents) {
    Vector extent(3);
    const Vector semi_axes{{1, 0.5, 2}};
    ASSERT_TRUE(is_unconditional(PNormBall(Vector::Zero(3), semi_axes, p), extent.data()));
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(extent[k], 0);
      const long double share = static_cast<long double>(extent[k]) / semi_axes[k];
      EXPECT_LE(std::log10(share) * p, -39.9L) << "p = " << p;
    }
  }
}

TEST(Unconditional, FacesOfLargePAreAlmostThoseOfABox) {
  Vector extent(2);
  ASSERT_TRUE(is_unconditional(PNormBall(Vector::Zero(2), Vector::Ones(2), 1e6), extent.data()));
  EXPECT_GT(extent[0], 0.9999);
  EXPECT_LT(extent[0], 1);
}

TEST(Unconditional, AreSumsAndDifferencesOfSuchSets) {
  const auto cube = std::make_shared<PNormBall>(Vector::Zero(2), Vector{{1, 2}}, 1e6);
  const auto other = std::make_shared<PNormBall>(Vector::Ones(2), Vector{{0.5, 4}}, 1e9);
  Vector extent(2);
  ASSERT_TRUE(is_unconditional(MinkowskiSum(cube, other), extent.data()));
  EXPECT_NEAR(extent[0], 1.5, 1e-3);
  ASSERT_TRUE(is_unconditional(MinkowskiDifference(cube, other), extent.data()));
  EXPECT_NEAR(extent[1], 6, 1e-3);
  const auto tilted = std::make_shared<Ellipsoid>(Vector::Zero(2), Eigen::Matrix2d{{1, 0.5}, {0, 1}});
  EXPECT_FALSE(is_unconditional(MinkowskiSum(cube, tilted), extent.data()));
}

// [c - e, c + e] is within the face of the exact set, although c is a rounded sum.
TEST(Unconditional, FacesOfSumsAndPosedSetsAllowForARoundedCenter) {
  Random random(92);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector first = 1e6 * gaussian_points(2, 1, random), second = 1e-3 * gaussian_points(2, 1, random);
    const auto S = std::make_shared<PNormBall>(first, Vector::Ones(2), 1e9);
    const auto T = std::make_shared<PNormBall>(second, Vector{{0.5, 4}}, 1e9);
    Vector e_S(2), e_T(2), extent(2), of_posed(2);
    ASSERT_TRUE(is_unconditional(*S, e_S.data()) && is_unconditional(*T, e_T.data()));
    const MinkowskiSum sum(S, T);
    ASSERT_TRUE(is_unconditional(sum, extent.data()));
    const Pose pose(Eigen::Matrix2d{{0, -1}, {1, 0}}, second);
    const PosedView posed(*S, pose);
    ASSERT_TRUE(is_unconditional(posed, of_posed.data()));
    const Vector turned{{-first[1], first[0]}};
    for (int k = 0; k < 2; ++k) {
      const Quad exact = Quad{first[k]} + second[k], moved = Quad{turned[k]} + second[k];
      const Quad off = elementary::fabs(exact - sum.center()[k]);
      EXPECT_LE(off + extent[k], Quad{e_S[k]} + e_T[k]);
      EXPECT_GE(extent[k], (e_S[k] + e_T[k]) * (1 - 1e-8));
      EXPECT_LE(elementary::fabs(moved - posed.center()[k]) + of_posed[k], Quad{e_S[1 - k]});
    }
  }
}

TEST(Unconditional, IsNotKnownOfPolytopesAndOfOtherSets) {
  Vector extent(2);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double p : {1.0, infinity}) {
    EXPECT_FALSE(is_unconditional(PNormBall(Vector::Zero(2), Vector::Ones(2), p), extent.data()));
  }
  const Ellipsoid ellipsoid(Vector::Zero(2), Eigen::Matrix2d{{1, 0.5}, {0, 1}});
  EXPECT_FALSE(is_unconditional(ellipsoid, extent.data()));
}

// What the summands say of themselves against their support points and differences of these.
TEST(Unconditional, SummandsAreReportedWithTheirReachAndItsChange) {
  Random random(97);
  const Vector zero = Vector::Zero(4), semi_axes{{1, 0.5, 2, 4}};
  const auto ellipsoid =
      std::make_shared<Ellipsoid>(gaussian_points(4, 1, random).col(0), gaussian_points(4, 4, random));
  for (const double p : {1.5, 3.0, 10.0}) {
    const auto ball = std::make_shared<PNormBall>(gaussian_points(4, 1, random).col(0), semi_axes, p);
    const MinkowskiSum sum(ellipsoid, ball);
    const MinkowskiDifference difference(ellipsoid, ball);
    const Vector u = gaussian_points(4, 1, random);
    Vector reach(4), change(4), extent(4), center(4), s(4), moved(4);
    EXPECT_FALSE(is_unconditional(sum, extent.data()));
    ASSERT_TRUE(sum.symmetry()->summands(u.data(), reach.data(), change.data())) << "p = " << p;
    ball->center_unchecked(center.data());
    ball->support_unchecked(u.data(), s.data());
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(reach[k], std::fabs(s[k] - center[k]), 1e-13);
      constexpr double kStep = 1e-6;
      Vector v = u;
      v[k] *= 1 + kStep;
      ball->support_unchecked(v.data(), moved.data());
      EXPECT_NEAR(change[k], std::fabs(moved[k] - s[k]) / kStep, 1e-4 * (1 + change[k]));
    }
    Vector of_difference(4);
    ASSERT_TRUE(difference.symmetry()->summands(u.data(), of_difference.data(), change.data()));
    EXPECT_NEAR((of_difference - reach).norm(), 0, 1e-13) << "the ball is symmetric";
  }
  const MinkowskiSum none(ellipsoid, ellipsoid);
  EXPECT_EQ(none.symmetry(), nullptr);
}

}  // namespace
}  // namespace raygauge::test_unconditional
