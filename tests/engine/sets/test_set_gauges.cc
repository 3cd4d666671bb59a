// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Gauges and their normals, where sets have formulas for them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/kernels/kernel.h"
#include "engine/methods/column_generation/support_oracle.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_set_gauges {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// x = t s(normal) for some t: what makes `normal` the normal of tS at x.
void expect_normal_at(const ConvexSet& S, const Vector& x, double error = 1e-24) {
  const int n = S.dimension();
  const std::vector<Quad> target(x.begin(), x.end());
  std::vector<Quad> normal(target.size()), points(target.size() * 8), hessians(points.size() * target.size());
  ASSERT_TRUE(gauge_normal(S, target.data(), normal.data()));
  QuadSupportPieces pieces;
  pieces.dimension = n;
  pieces.points = points.data();
  pieces.hessians = hessians.data();
  support_pieces(S, normal.data(), pieces);
  const Quad* s = pieces.point(0);
  const Quad t = dot(target.data(), s, n) / dot(s, s, n);
  for (int k = 0; k < n; ++k) {
    const Quad residual = elementary::fabs(target[static_cast<std::size_t>(k)] - t * s[k]);
    EXPECT_LT(static_cast<double>(residual), error * x.norm()) << "coordinate " << k;
  }
}

TEST(Gauge, OfAPNormBallIsItsNorm) {
  const Vector w{{2, 0.5, 1}}, x{{3, -1, 0.25}};
  Vector normal(3);
  for (const double p : {1.0, 1.5, 2.0, 3.0, 100.0}) {
    const PNormBall ball(Vector::Zero(3), w, p);
    const long double exact =
        std::pow(std::pow(1.5L, static_cast<long double>(p)) + std::pow(2.0L, static_cast<long double>(p)) +
                     std::pow(0.25L, static_cast<long double>(p)),
                 1 / static_cast<long double>(p));
    const double gauge = gauge_bound(ball, x.data(), normal.data());
    EXPECT_GE(gauge, exact) << "p = " << p;
    EXPECT_LE(gauge, exact * (1 + 1e-14L)) << "p = " << p;
    EXPECT_NEAR(normal.dot(x), gauge * ball.support_function(normal), 1e-12 * normal.norm()) << "p = " << p;
  }
}

TEST(Gauge, OfAnEvenLargerPIsTheLargestCoordinate) {
  const PNormBall ball(Vector::Zero(2), Vector::Ones(2), 1e6);
  const Vector x{{-7, 6.5}};
  Vector normal(2);
  EXPECT_NEAR(gauge_bound(ball, x.data(), normal.data()), 7, 1e-13);
  EXPECT_LT(normal[0], 0);
  EXPECT_EQ(normal[1], 0);
}

TEST(Gauge, IsUnknownWhereAQuotientUnderflows) {
  const Vector x{{5 * std::numeric_limits<double>::denorm_min(), 0}};  // 5/2 of it is not representable
  Vector normal(2);
  EXPECT_EQ(gauge_bound(PNormBall(Vector::Zero(2), Vector{{2, 2}}, 3), x.data(), normal.data()), kInfinity);
}

TEST(Gauge, OfAScaledSetIsUnknownWhereUnscalingUnderflows) {
  const PNormBall ball(Vector::Zero(2), Vector{{0x1p-1000, 0x1p-1000}}, 3);
  const double factor[2] = {0x1p1000, 0x1p1000};
  SupportOracle oracle;
  oracle.bind(ball, factor, best_kernels());
  Vector normal(2);
  const Vector x{{0.75, 0}}, tiny{{1e-20, 0}};  // tiny: 1e-321 beside the ball itself
  EXPECT_GE(oracle.gauge(x.data(), normal.data()), 0.75);
  EXPECT_EQ(oracle.gauge(tiny.data(), normal.data()), kInfinity);
}

TEST(Gauge, IsUnknownAwayFromTheOrigin) {
  const Vector x = Vector::Ones(2);
  Vector normal(2);
  EXPECT_EQ(gauge_bound(PNormBall(Vector::Ones(2), Vector::Ones(2), 3), x.data(), normal.data()), kInfinity);
  EXPECT_EQ(gauge_bound(PNormBall(Vector::Zero(2), Vector{{1, 0}}, 3), x.data(), normal.data()), kInfinity);
  EXPECT_EQ(gauge_bound(Ball(Vector::Zero(2), 1), x.data(), normal.data()), kInfinity);
}

TEST(GaugeNormal, IsWhereTheRayLeavesTheSet) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vector x = gaussian_points(4, 1, random);
    const Vector c = 0.4 * sphere_points(4, 1, random);
    expect_normal_at(Ball(c, 1), x);
    expect_normal_at(PNormBall(Vector::Zero(4), Vector{{1, 2, 4, 0.5}}, 2.5), x);
    Eigen::MatrixXd L = gaussian_points(4, 4, random);
    L.col(1) *= 1e8;
    expect_normal_at(Ellipsoid(Vector::Zero(4), L), x, 1e-14);  // the square of the condition of L
  }
}

TEST(GaugeNormal, IsOfTheBallThatTouchesTheOrigin) {
  expect_normal_at(Ball(Vector{{3, 4}}, 5), Vector{{1, 1e-9}});
  std::vector<Quad> normal(2);
  const std::vector<Quad> behind = {-1, -1};
  EXPECT_FALSE(gauge_normal(Ball(Vector{{3, 4}}, 5), behind.data(), normal.data()));
  EXPECT_FALSE(gauge_normal(Ellipsoid(Vector::Zero(2), Eigen::MatrixXd{{1, 2}, {2, 4}}), behind.data(),
                            normal.data()));
}

TEST(TouchingTheOrigin, IsDecidedWithoutRounding) {
  Vector u(2);
  EXPECT_TRUE(touches_origin(Ball(Vector{{3, -4}}, 5), u.data()));
  EXPECT_EQ(u, (Vector{{-3, 4}}));
  EXPECT_FALSE(touches_origin(Ball(Vector{{3, -4}}, std::nextafter(5, 6)), u.data()));
  EXPECT_FALSE(touches_origin(Ball(Vector{{3, -4}}, std::nextafter(5, 4)), u.data()));
  EXPECT_FALSE(touches_origin(Ball(Vector::Zero(2), 0), u.data()));
}

}  // namespace
}  // namespace raygauge::test_set_gauges
