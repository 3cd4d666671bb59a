// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/round_growth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_round_growth {
namespace {

using Body = std::shared_ptr<const ConvexSet>;
using Eigen::Vector3d;
using testing::gaussian;
using testing::Random;
using testing::random_rotation;

constexpr double kTolerance = 1e-6;

GrowthDistanceSolver make_solver(bool general) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = kTolerance;
  if (general) options.max_iterations = 100000;  // fixed-size code stands aside
  return GrowthDistanceSolver(options);
}

std::vector<Body> bodies() {
  const Vector3d zero = Vector3d::Zero(), up(0, 0, 0.6), half(0.6, 0.5, 0.4);
  return {std::make_shared<Ball>(zero, 0.8), std::make_shared<Capsule>(-up, up, 0.4),
          std::make_shared<Ellipsoid>(zero, Eigen::MatrixXd(Vector3d(1, 0.6, 0.4).asDiagonal())),
          std::make_shared<Box>(-half, half), std::make_shared<TruncatedCone>(-up, 0.6, up, 0.2)};
}

TEST(RoundGrowth, AgreesWithTheGeneralMethodsColdAndWarm) {
  Random random(29);
  GrowthDistanceSolver quick = make_solver(false), general = make_solver(true);
  for (const Body& one : bodies()) {
    for (const Body& two : bodies()) {
      WarmStart memory;
      Pose at(random_rotation(random).toRotationMatrix(), gaussian(random));
      for (int frame = 0; frame < 5; ++frame) {
        at = Pose(Eigen::AngleAxisd(0.05, gaussian(random).normalized()) * at.rotation(),
                  at.translation() + 0.02 * gaussian(random));
        const DistanceResult truth = general.solve_about_centers({*one, Pose(3)}, {*two, at});
        ASSERT_EQ(truth.status, DistanceStatus::optimal);
        for (WarmStart* start : {static_cast<WarmStart*>(nullptr), &memory}) {
          const DistanceResult& r = quick.solve_about_centers({*one, Pose(3)}, {*two, at}, start);
          EXPECT_EQ(r.status, DistanceStatus::optimal);
          EXPECT_LE(r.upper - r.lower, kTolerance * r.upper);
          EXPECT_LE(r.lower, truth.upper);
          EXPECT_GE(r.upper, truth.lower);
        }
      }
    }
  }
}

// Beside each other, so that the ray leaves through the middle of the segments, where 0 is.
TEST(RoundGrowth, OfParallelCapsulesIsThatOfTheirRadii) {
  const Vector3d up(0, 0, 1);
  const Capsule one(-up, up, 0.25), two(-up, up, 0.5);
  const Pose beside(Eigen::Matrix3d::Identity(), Vector3d(3, 0, 0));
  GrowthDistanceSolver solver = make_solver(false);
  const DistanceResult& r = solver.solve_about_centers({one, Pose(3)}, {two, beside});
  EXPECT_LE(r.lower, 4);
  EXPECT_GE(r.upper, 4);
  EXPECT_LE(r.counters.support_queries, 6);
}

TEST(RoundGrowth, OfEllipsoidsTakesThreeSupportPointsAtMost) {
  Random random(31);
  GrowthDistanceSolver solver = make_solver(false);
  const Ellipsoid one(Vector3d::Zero(), Eigen::MatrixXd(Vector3d(1, 0.6, 0.4).asDiagonal()));
  for (int trial = 0; trial < 100; ++trial) {
    const Pose first(random_rotation(random).toRotationMatrix(), gaussian(random));
    const Pose second(random_rotation(random).toRotationMatrix(), first.translation() + 3 * gaussian(random));
    EXPECT_LE(solver.solve_about_centers({one, first}, {one, second}).counters.support_queries, 6) << trial;
  }
}

}  // namespace
}  // namespace raygauge::test_round_growth
