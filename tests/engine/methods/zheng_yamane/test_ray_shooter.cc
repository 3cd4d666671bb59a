// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/zheng_yamane/ray_shooter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_ray_shooter {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One ray after another at A - a_c - ηQ.
struct Rays {
  Rays(const ConvexSet& A, const ConvexSet& Q) {
    oracle_A.bind(A, nullptr, best_kernels());
    oracle_Q.bind(Q, nullptr, best_kernels());
    center = A.center();
    shooter.begin(oracle_A, oracle_Q, A.dimension(), center.data(), best_kernels());
  }
  RayShooter::End shoot(double eta, double tolerance = 1e-12, double overtaking = kInfinity,
                        std::int64_t limit = 1000) {
    return shooter.shoot(eta, tolerance, overtaking, limit, stopwatch);
  }

  SupportOracle oracle_A, oracle_Q;
  Vector center;
  Stopwatch stopwatch;
  RayShooter shooter;
};

// Points on two unit spheres, the first shifted along the first axis.
struct Spheres {
  Spheres(int n, int N, double shift, unsigned seed)
      : A(points(n, N, shift, seed)), Q(points(n, N, 0, seed)) {}
  static Eigen::MatrixXd points(int n, int N, double shift, unsigned seed) {
    Random random(seed);
    Eigen::MatrixXd points = sphere_points(n, N, random);
    points.row(0).array() += shift;
    return points;
  }
  PointSet A, Q;
};

// A and ηQ both grow by σ until they touch: (1 + η) σ = |a_c|.
TEST(RayShooter, FindsTheGrowthOfTwoBalls) {
  for (const int n : {2, 3, 6}) {
    Vector center = Vector::Zero(n);
    center[0] = 2;
    center[n - 1] = 1.5;  // |c| = 2.5
    const Ball A(center, 1.0), Q(Vector::Zero(n), 1.0);
    Rays rays(A, Q);
    for (const double eta : {1.0, 1.2, 1.5}) {  // each from the vertices of the one before
      ASSERT_EQ(rays.shoot(eta), RayShooter::End::hit) << n;
      EXPECT_NEAR(rays.shooter.sigma(), 2.5 / (1 + eta), 1e-10);
      const Eigen::Map<const Eigen::VectorXd> u(rays.shooter.normal(), n);
      EXPECT_NEAR(-u.dot(Eigen::VectorXd(center)) / (u.norm() * 2.5), 1, 1e-9) << "against the ray";
      EXPECT_NEAR(rays.shooter.set().h_Q().value, u.norm(), 1e-12 * u.norm());
    }
  }
}

TEST(RayShooter, HitsAFaceOfBoxes) {
  const Box A(Vector{{2.0, -1.0}}, Vector{{4.0, 1.0}}), Q(Vector{{-1.0, -1.0}}, Vector{{1.0, 1.0}});
  Rays rays(A, Q);
  ASSERT_EQ(rays.shoot(1), RayShooter::End::hit);
  EXPECT_NEAR(rays.shooter.sigma(), 1.5, 1e-12);
  ASSERT_EQ(rays.shoot(2), RayShooter::End::hit);
  EXPECT_NEAR(rays.shooter.sigma(), 1, 1e-12) << "d = 2";
}

// The vertices are pairs of points whose hull the ray leaves through.
TEST(RayShooter, HitsPointSetsAtTheirOwnPoints) {
  for (const int n : {2, 4, 20}) {
    const auto [A, Q] = Spheres(n, 30 * n, 3, 6);
    Rays rays(A, Q);
    ASSERT_EQ(rays.shoot(1), RayShooter::End::hit) << n;
    EXPECT_GT(rays.shooter.sigma(), 1);
    int vertices = 0;
    for (int l = 0; l < n; ++l) {
      const std::int64_t slot = rays.shooter.vertex(l);
      if (slot < 0) continue;
      const double* a = rays.shooter.set().slot_A(slot);
      ++vertices;
      bool is_point = false;
      for (std::ptrdiff_t i = 0; i < A.size() && !is_point; ++i)
        is_point = std::equal(a, a + n, A.point(i).data());
      EXPECT_TRUE(is_point);
    }
    EXPECT_GE(vertices, 1);
  }
}

TEST(RayShooter, LeavesARayWhoseNormalProvesAMuchLargerEta) {
  const auto [A, Q] = Spheres(30, 200, 40, 7);
  Rays rays(A, Q);
  ASSERT_EQ(rays.shoot(1, 1e-7, 2.0), RayShooter::End::overtaken);
  EXPECT_GE(-rays.shooter.set().h_A().value / rays.shooter.set().h_Q().value, 2);
}

TEST(RayShooter, StopsAtItsLimitOfIterations) {
  const auto [A, Q] = Spheres(10, 400, 3, 8);
  Rays rays(A, Q);
  EXPECT_EQ(rays.shoot(1, 1e-12, kInfinity, 5), RayShooter::End::iteration_limit);
  EXPECT_LE(rays.shooter.set().iterations(), 6);
}

}  // namespace
}  // namespace raygauge::test_ray_shooter
