// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_gauge.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/membership.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_spatial_gauge {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;
using testing::gaussian;
using testing::Random;

constexpr int kKinds = 5;

// Of kind 0 … 4 about a centre, its sizes between 0.5 and 1.5, turned at random.
SetPointer body(int kind, const Eigen::Vector3d& center, Random& random) {
  std::uniform_real_distribution<double> size(0.5, 1.5);
  const Eigen::Vector3d half = gaussian(random).normalized() * size(random);
  const Eigen::Vector3d p = center - half, q = center + half;
  const Eigen::Matrix3d axes = Eigen::Vector3d(size(random), size(random), size(random)).asDiagonal();
  const Eigen::Vector4d turn(gaussian(random).x(), gaussian(random).y(), gaussian(random).z(), 1);
  const Eigen::Matrix3d R = Eigen::Quaterniond(turn.normalized()).toRotationMatrix();
  switch (kind) {
    case 0:
      return std::make_shared<Ball>(center, size(random));
    case 1:
      return std::make_shared<Capsule>(p, q, size(random));
    case 2:
      return std::make_shared<Cylinder>(p, q, size(random));
    case 3:
      return std::make_shared<TruncatedCone>(p, size(random), q, size(random));
    default:
      return std::make_shared<Ellipsoid>(center, R * axes);
  }
}

// One solve by this method alone.
struct Solve {
  Solve(const ConvexSet& A, const ConvexSet& Q, double tolerance) {
    options.tolerance = tolerance;
    stopwatch.start(std::numeric_limits<double>::infinity());
    SpatialGauge method;
    concluded = method.solve(Problem{A, Q, options, stopwatch, Effects::witness}, result);
  }
  DistanceOptions options;
  Stopwatch stopwatch;
  DistanceResult result;
  bool concluded = false;
};

// A limit on the iterations is what this method does not have: it sends a solve to the general one.
DistanceResult by_general_method(const ConvexSet& A, const ConvexSet& Q, double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  options.max_iterations = 10000;
  return DistanceSolver(options).solve(A, Q);
}

TEST(SpatialGauge, BoundsOverlapThoseOfTheGeneralMethod) {
  Random random(81);
  int concluded = 0, solves = 0;
  for (int kind_A = 0; kind_A < kKinds; ++kind_A) {
    for (int kind_Q = 0; kind_Q < kKinds; ++kind_Q) {
      for (int trial = 0; trial < 60; ++trial, ++solves) {
        const double away = trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? 3.5 : 1e3;
        const auto A = body(kind_A, away * gaussian(random), random);
        const auto Q = body(kind_Q, Eigen::Vector3d::Zero(), random);
        const double tolerance = trial % 2 == 0 ? 1e-8 : 1e-10;
        const Solve solve(*A, *Q, tolerance);
        const DistanceResult general = by_general_method(*A, *Q, tolerance);
        if (!solve.concluded) continue;
        ++concluded;
        const DistanceResult& r = solve.result;
        EXPECT_EQ(r.status, DistanceStatus::optimal);
        EXPECT_LE(r.lower, r.distance);
        EXPECT_LE(r.distance, r.upper);
        EXPECT_LE(r.upper - r.lower, tolerance * r.upper);
        EXPECT_LE(r.lower, general.upper) << kind_A << " " << kind_Q;
        EXPECT_LE(general.lower, r.upper) << kind_A << " " << kind_Q;
      }
    }
  }
  EXPECT_GT(concluded, solves * 8 / 10);
}

// The normal proves the lower bound by weak duality, the contact point the upper one: it is in A, and its
// gauge is no more.
TEST(SpatialGauge, NormalsAndContactPointsProveTheBoundsAfterwards) {
  Random random(82);
  for (int trial = 0; trial < 400; ++trial) {
    const auto A = body(trial % kKinds, 4 * gaussian(random).normalized(), random);
    const auto Q = body(trial / kKinds % kKinds, Eigen::Vector3d::Zero(), random);
    const Solve solve(*A, *Q, 1e-9);
    if (!solve.concluded) continue;
    const DistanceResult& r = solve.result;
    EXPECT_NEAR(-A->support_function(r.normal) / Q->support_function(-r.normal), r.lower, 1e-11 * r.lower);
    EXPECT_NEAR(Q->support_function(-r.normal), 1, 1e-12);
    EXPECT_NEAR(gauge(*Q, r.contact_point, 1e-9).upper, r.upper, 1e-7 * r.upper);
    const Eigen::Vector3d inwards = A->center() - Eigen::Vector3d(r.contact_point);
    EXPECT_EQ(contains(*A, r.contact_point + 1e-9 * inwards, 1e-12), Membership::inside);
  }
}

TEST(SpatialGauge, KnowsClosedForms) {
  const Ball unit(Eigen::Vector3d::Zero(), 1), far(Eigen::Vector3d(4, 0, 0), 1);
  EXPECT_NEAR(Solve(far, unit, 1e-10).result.distance, 3, 1e-9);
  // Contact within a disc of A, and of Q.
  const Cylinder lying(Eigen::Vector3d(0.2, 0.1, 2), Eigen::Vector3d(0.2, 0.1, 3), 1.5);
  const Ellipsoid flat(Eigen::Vector3d::Zero(), Eigen::Vector3d(1, 1, 0.5).asDiagonal().toDenseMatrix());
  const Solve on_A(lying, flat, 1e-10);
  ASSERT_TRUE(on_A.concluded);
  EXPECT_NEAR(on_A.result.distance, 4, 1e-9);
  const Cylinder drum(Eigen::Vector3d(0, 0, -0.5), Eigen::Vector3d(0, 0, 0.5), 2);
  const Ball above(Eigen::Vector3d(0.3, 0.4, 3), 1);
  const Solve on_Q(above, drum, 1e-10);
  ASSERT_TRUE(on_Q.concluded);
  EXPECT_NEAR(on_Q.result.distance, 4, 1e-9);
}

TEST(SpatialGauge, LeavesOtherSetsAndAnOriginInAToOtherMethods) {
  const Ball unit(Eigen::Vector3d::Zero(), 1), around(Eigen::Vector3d(0.5, 0, 0), 1);
  const Box box(Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(3, 3, 3));
  const Ball beside(Eigen::Vector3d(3, 0, 0), 1);
  EXPECT_FALSE(Solve(around, unit, 1e-6).concluded);
  EXPECT_FALSE(Solve(box, unit, 1e-6).concluded);
  EXPECT_FALSE(Solve(unit, beside, 1e-6).concluded);
  EXPECT_EQ(by_general_method(around, unit, 1e-6).status, DistanceStatus::contains_origin);
}

}  // namespace
}  // namespace raygauge::test_spatial_gauge
