// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_query.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_spatial_query {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;
using testing::gaussian;
using testing::Random;

const Eigen::Vector3d kZero = Eigen::Vector3d::Zero();

Pose random_pose(Random& random, double size) {
  const Eigen::Vector3d axis = gaussian(random).normalized();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(gaussian(random).norm(), axis)), size * gaussian(random)};
}

Eigen::MatrixXd sphere(int N, Random& random) {
  Eigen::MatrixXd points(3, N);
  for (int i = 0; i < N; ++i) points.col(i) = gaussian(random).normalized();
  return points;
}

std::vector<SetPointer> bodies(Random& random) {
  const Eigen::Vector3d up(0, 0, 0.6);
  const Eigen::Matrix3d factor = Eigen::Vector3d(1, 0.6, 0.4).asDiagonal();
  return {std::make_shared<Ball>(Eigen::Vector3d(0.1, 0, 0), 0.8),
          std::make_shared<Box>(Eigen::Vector3d(-0.6, -0.5, -0.4), Eigen::Vector3d(0.6, 0.5, 0.4)),
          std::make_shared<Capsule>(Eigen::Vector3d(-up), up, 0.4),
          std::make_shared<Cylinder>(Eigen::Vector3d(-up), up, 0.5),
          std::make_shared<TruncatedCone>(Eigen::Vector3d(-up), 0.6, up, 0.3),
          std::make_shared<Ellipsoid>(kZero, factor),
          std::make_shared<PointSet>(sphere(8, random)),
          std::make_shared<PointSet>(sphere(100, random)),
          std::make_shared<PreparedSet>(sphere(100, random))};
}

// A limit on the iterations is what only the general methods have: options that send a query their way.
DistanceOptions general_options(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  options.max_iterations = 100000;
  return options;
}

DistanceOptions spatial_options(double tolerance) {
  DistanceOptions options = general_options(tolerance);
  options.max_iterations = 0;
  return options;
}

void expect_overlap(const DistanceResult& one, const DistanceResult& two, double tolerance) {
  EXPECT_LE(one.lower, two.upper);
  EXPECT_LE(two.lower, one.upper);
  EXPECT_LE(one.upper - one.lower, tolerance * one.upper);
}

// Far, near and overlapping pairs, against the general methods, whose proofs are others.
TEST(SpatialQuery, BoundsOverlapThoseOfTheGeneralMethods) {
  constexpr double kTolerance = 1e-6;
  Random random(21);
  const Ball metric(kZero, 1);
  const auto sets = bodies(random);
  ObjectDistanceSolver general(general_options(kTolerance));
  GrowthDistanceSolver general_growth(general_options(kTolerance));
  SpatialQuery query;
  ObjectDistance distance;
  DistanceResult growth;
  int solved = 0, asked = 0;
  for (const auto& A1 : sets) {
    for (const auto& A2 : sets) {
      for (const double size : {3.0, 1.0, 0.3}) {
        const Pose one = random_pose(random, size), two = random_pose(random, size);
        const DistanceOptions options = spatial_options(kTolerance);
        asked += 2;
        if (query.distance({*A1, one}, {*A2, two}, metric, options, ObjectEffects::none, nullptr, distance)) {
          ++solved;
          const auto& reference = general.solve({*A1, one}, {*A2, two}, metric);
          expect_overlap(distance.distance, reference.distance, kTolerance);
        }
        if (query.growth({*A2, two}, {*A1, one}, false, options, std::nan(""), nullptr, growth)) {
          ++solved;
          expect_overlap(growth, general_growth.solve_about_centers({*A1, one}, {*A2, two}), kTolerance);
        }
      }
    }
  }
  EXPECT_GT(solved, asked * 95 / 100);
}

TEST(SpatialQuery, NormalsAndClosestPointsProveTheBoundsAfterwards) {
  Random random(22);
  const Ball metric(kZero, 1);
  const auto sets = bodies(random);
  ObjectDistanceSolver solver;
  for (const auto& A1 : sets) {
    for (const auto& A2 : sets) {
      const Pose one = random_pose(random, 0),
                 two(Eigen::Quaterniond::Identity(), 4 * gaussian(random).normalized());
      const auto& r = solver.solve({*A1, one}, {*A2, two}, metric, ObjectEffects::closest_points);
      ASSERT_EQ(r.distance.status, DistanceStatus::optimal);
      const Vector& u = r.distance.normal;
      EXPECT_NEAR(u.norm(), 1, 1e-14);
      const double h_1 = A1->support_function(one.rotation().transpose() * -u);
      const double h_2 = A2->support_function(two.rotation().transpose() * u) + u.dot(two.translation());
      EXPECT_NEAR(-(h_1 + h_2), r.distance.lower, 1e-12);
      EXPECT_NEAR((r.closest_point_2 - r.closest_point_1).norm(), r.distance.upper, 1e-12);
    }
  }
}

// A chain of small motions with one WarmStart, each frame against a cold solve.
TEST(SpatialQuery, WarmFramesAgreeWithColdOnesAndTakeFewerSteps) {
  Random random(23);
  const auto sets = bodies(random);
  const Ball metric(kZero, 1);
  ObjectDistanceSolver warm_solver, cold_solver;
  GrowthDistanceSolver warm_growth, cold_growth;
  std::int64_t warm_steps = 0, cold_steps = 0;
  for (const auto& A1 : sets) {
    for (const auto& A2 : sets) {
      WarmStart warm, grown;
      const Eigen::Vector3d way = gaussian(random).normalized(), axis = gaussian(random).normalized();
      for (int frame = 0; frame < 30; ++frame) {
        const Pose one(3),
            two(Eigen::Quaterniond(Eigen::AngleAxisd(0.01 * frame, axis)), (3 - 0.1 * frame) * way);
        const auto& w = warm_solver.solve({*A1, one}, {*A2, two}, metric, ObjectEffects::none, &warm);
        const auto& c = cold_solver.solve({*A1, one}, {*A2, two}, metric);
        EXPECT_LE(w.distance.lower, c.distance.upper);
        EXPECT_LE(c.distance.lower, w.distance.upper);
        EXPECT_EQ(w.distance.status, c.distance.status);
        warm_steps += w.distance.counters.support_queries;
        cold_steps += c.distance.counters.support_queries;
        const auto& g = warm_growth.solve_about_centers({*A1, one}, {*A2, two}, &grown);
        const auto& h = cold_growth.solve_about_centers({*A1, one}, {*A2, two});
        EXPECT_LE(g.lower, h.upper);
        EXPECT_LE(h.lower, g.upper);
      }
    }
  }
  EXPECT_LT(warm_steps, cold_steps);
}

TEST(SpatialQuery, KnowsClosedForms) {
  const Pose one(3), two(Eigen::Quaterniond::Identity(), Eigen::Vector3d(3, 0, 0));
  const Ball metric(kZero, 2);
  ObjectDistanceSolver solver;
  const Ball ball(kZero, 0.5);
  const Box box(Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1));
  EXPECT_NEAR(solver.solve({ball, one}, {box, two}, metric).distance.distance, 1.5 / 2, 1e-6);
  GrowthDistanceSolver growth;
  EXPECT_NEAR(growth.solve_about_centers({box, one}, {box, two}).distance, 1.5, 1e-6);
  EXPECT_NEAR(growth.solve_about_centers({ball, one}, {box, two}).distance, 2, 1e-6);
}

// Fixed-size code ends before a clock would be read, unless there are many points.
TEST(SpatialQuery, StandsAsideUnderALimitOfTimeWhereThereAreManyPoints) {
  Random random(71);
  const PointSet few(sphere(100, random)), many(sphere(20000, random));
  const Pose away(Eigen::Quaterniond::Identity(), Eigen::Vector3d(3, 0, 0));
  const Ball metric(kZero, 1);
  DistanceOptions limited = spatial_options(1e-6);
  limited.time_limit = 1;
  SpatialQuery query;
  ObjectDistance r;
  const auto solves = [&](const PointSet& A, const DistanceOptions& options) {
    return query.distance({A, Pose(3)}, {few, away}, metric, options, ObjectEffects::none, nullptr, r);
  };
  EXPECT_TRUE(solves(few, limited));
  EXPECT_FALSE(solves(many, limited));
  EXPECT_TRUE(solves(many, spatial_options(1e-6)));
}

// With o + a in doubles a simplex is the point set of its vertices; where that is rounded it is not.
TEST(SpatialQuery, SolvesSimplicesWhoseVerticesAreDoubles) {
  const Eigen::Vector3d corner(-0.25, 0.5, 0), legs(1, -0.75, 0.5);
  const Simplex simplex(corner, legs), rounded(corner, Eigen::Vector3d(1e-17, 1, 1));
  Eigen::MatrixXd vertices = corner.replicate(1, 4);
  for (int k = 0; k < 3; ++k) vertices(k, k + 1) += legs[k];
  const PointSet points(vertices);
  const Capsule capsule(Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(1, 0, 0), 0.5);
  Random random(72);
  SpatialQuery query;
  const Ball metric(kZero, 1);
  const DistanceOptions options = spatial_options(1e-6);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose one = random_pose(random, 2), two = random_pose(random, 2);
    ObjectDistance of_simplex, of_points;
    ASSERT_TRUE(query.distance({simplex, one}, {capsule, two}, metric, options, ObjectEffects::none, nullptr,
                               of_simplex));
    ASSERT_TRUE(query.distance({points, one}, {capsule, two}, metric, options, ObjectEffects::none, nullptr,
                               of_points));
    EXPECT_EQ(of_simplex.distance.status, of_points.distance.status);
    expect_overlap(of_simplex.distance, of_points.distance, 1e-6);
    DistanceResult growth, general;
    ASSERT_TRUE(query.growth({simplex, one}, {capsule, two}, false, options, std::nan(""), nullptr, growth));
    general = GrowthDistanceSolver(general_options(1e-6)).solve_about_centers({simplex, one}, {capsule, two});
    expect_overlap(growth, general, 1e-6);
  }
  ObjectDistance r;
  EXPECT_FALSE(query.distance(rounded, capsule, metric, options, ObjectEffects::none, nullptr, r));
}

// The plane, with a Euclidean metric that is a p-norm ball.
TEST(SpatialQuery, SolvesInThePlane) {
  const Box square(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  const Capsule capsule(Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0), 0.5);
  const PNormBall metric(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1), 2);
  Eigen::Isometry2d turned = Eigen::Isometry2d::Identity();
  turned.rotate(std::acos(-1) / 4);
  turned.pretranslate(Eigen::Vector2d(4, 0));
  SpatialQuery query;
  ObjectDistance r;
  ASSERT_TRUE(query.distance({square, Pose(turned)}, {capsule, Pose(2)}, metric, spatial_options(1e-9),
                             ObjectEffects::closest_points, nullptr, r));
  EXPECT_NEAR(r.distance.distance, 4 - std::sqrt(2) - 1.5, 1e-9);
  EXPECT_EQ(r.closest_point_1.size(), 2);
  DistanceResult growth;
  ASSERT_TRUE(query.growth({square, Pose(turned)}, {square, Pose(2)}, false, spatial_options(1e-9),
                           std::nan(""), nullptr, growth));
  EXPECT_NEAR(growth.distance, 4 / (1 + std::sqrt(2)), 1e-8);
}

}  // namespace
}  // namespace raygauge::test_spatial_query
