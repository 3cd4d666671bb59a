// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/queries/depth_cases.h"

namespace raygauge::test_object_depth {
namespace {

using V = Eigen::Vector3d;

constexpr double kTolerance = 1e-6;
constexpr double kRounding = 1e-12;  // of what the tests compute themselves, for bodies of size 1
constexpr auto kAll = ObjectEffects::depth | ObjectEffects::gradient;

DistanceOptions options(double tolerance = kTolerance) {
  DistanceOptions result;
  result.tolerance = tolerance;
  return result;
}

Ball euclidean(int n) { return {Vector::Zero(n), 1.0}; }

// The interval holds `truth` and is as narrow as was asked for.
void expect_depth(const ObjectDepth& depth, double truth) {
  EXPECT_EQ(depth.status, DistanceStatus::optimal);
  EXPECT_LE(depth.lower, truth + kRounding);
  EXPECT_GE(depth.upper, truth - kRounding);
  EXPECT_LE(depth.upper - depth.lower, kTolerance * depth.upper);
}

TEST(ObjectDepth, OfBoxesIsTheLeastOverlapAlongAnAxis) {
  ObjectDistanceSolver solver(options());
  const Box A(V(0, 0, 0), V(2, 3, 4)), B(V(1.5, -1, -1), V(5, 6, 7));
  const ObjectDistance& r = solver.solve(A, B, euclidean(3), kAll);
  EXPECT_EQ(r.distance.status, DistanceStatus::contains_origin);
  expect_depth(r.depth, 0.5);
  EXPECT_EQ(r.signed_distance(), -r.depth.depth);
  EXPECT_LT((r.depth.normal - V(-1, 0, 0)).norm(), kRounding);
  EXPECT_LT((r.depth.point_2 - r.depth.point_1 - 0.5 * r.depth.normal).norm(), kRounding);
  EXPECT_EQ(r.gradient_1, r.depth.normal);
  EXPECT_EQ(r.gradient_2, -r.depth.normal);
}

TEST(ObjectDepth, OfPointsOnQuarterCoordinatesIsThatOfTheBox) {
  ObjectDistanceSolver solver(options());
  const PointSet A(cube_vertices(3)), B((0.5 * cube_vertices(3)).colwise() + V(0.25, 0, -1.25));
  expect_depth(solver.solve(A, B, euclidean(3), kAll).depth, 0.25);
  expect_depth(solver.solve(A, A, euclidean(3), kAll).depth, 2);
}

TEST(ObjectDepth, OfBoxesInUpToSixDimensionsIsTheLeastOverlapAlongAnAxis) {
  for (int n = 4; n <= 6; ++n) {
    ObjectDistanceSolver solver(options());
    const Box A(Vector::Zero(n), Vector::Ones(n)), B(Vector::Constant(n, 0.5), Vector::Constant(n, 3));
    Vector up = Vector::Zero(n);
    up[2] = 0.25;
    const Pose pose(Eigen::MatrixXd::Identity(n, n), up), still(n);
    const ObjectDepth& depth = solver.solve({A, still}, {B, pose}, euclidean(n), kAll).depth;
    expect_depth(depth, 0.25);
    EXPECT_LT((depth.normal + Vector::Unit(n, 2)).norm(), kRounding);
    EXPECT_LT((depth.point_2 - depth.point_1 - 0.25 * depth.normal).norm(), kRounding);
  }
}

TEST(ObjectDepth, OfBallsIsTheSumOfRadiiLessTheDistanceOfCentres) {
  ObjectDistanceSolver solver(options());
  const Ball A(V(0, 0, 0), 1.0), B(V(0.3, 0.4, 0), 0.75);
  const ObjectDistance& r = solver.solve(A, B, euclidean(3), kAll);
  expect_depth(r.depth, 1.25);
  EXPECT_LT((r.depth.normal - V(-0.6, -0.8, 0)).norm(), kRounding);
  EXPECT_LT((r.depth.point_1 - V(0.6, 0.8, 0)).norm(), kRounding);
  expect_depth(solver.solve(A, A, euclidean(3), kAll).depth, 2);
}

TEST(ObjectDepth, OfACrossingOfCapsulesIsThatOfTheirRadii) {
  ObjectDistanceSolver solver(options());
  const Capsule A(V(-1, 0, 0), V(1, 0, 0), 0.25), B(V(0, -1, 0), V(0, 1, 0), 0.5),
      C(V(0, -1, 0.125), V(0, 1, 0.125), 0.5);
  expect_depth(solver.solve(A, B, euclidean(3), kAll).depth, 0.75);
  expect_depth(solver.solve(A, C, euclidean(3), kAll).depth, 0.625);
  expect_depth(solver.solve(A, A, euclidean(3), kAll).depth, 0.5);
}

TEST(ObjectDepth, OfABallInABoxIsTheWayToTheNearestFaceAndItsRadius) {
  ObjectDistanceSolver solver(options());
  const Box box(V(-1, -2, -3), V(1, 2, 3));
  const Ball ball(V(0.5, 0.25, 0.125), 0.25);
  const ObjectDistance& r = solver.solve(ball, box, euclidean(3), kAll);
  expect_depth(r.depth, 0.75);
  EXPECT_LT((r.depth.normal - V(1, 0, 0)).norm(), kRounding);
}

TEST(ObjectDepth, OfRandomPolytopesIsThatOfTheLeastFacet) {
  Random random(1);
  ObjectDistanceSolver solver(options());
  for (int i = 0; i < 60; ++i) {
    const Eigen::MatrixXd P = gaussian_points(3, 6, random), R = gaussian_points(3, 7, random);
    const PointSet A(P), B(R);
    const ObjectDistance& r = solver.solve(A, B, euclidean(3), kAll);
    if (r.distance.lower > 0) continue;
    expect_depth(r.depth, depth_of_polytopes(P, R));
  }
}

TEST(ObjectDepth, OfNeedlesAndPlatesIsThatOfTheLeastFacet) {
  Random random(2);
  ObjectDistanceSolver solver(options());
  for (int i = 0; i < 60; ++i) {
    const double thin = std::pow(10.0, -1 - i % 8);
    const Eigen::MatrixXd P = V(1, thin, thin).asDiagonal() * gaussian_points(3, 6, random),
                          R = V(1, 1, thin).asDiagonal() * gaussian_points(3, 6, random);
    const PointSet A(P), B(R);
    const ObjectDistance& r = solver.solve(A, B, euclidean(3), kAll);
    if (r.distance.lower > 0) continue;
    EXPECT_EQ(r.depth.status, DistanceStatus::optimal) << thin;
    const double truth = depth_of_polytopes(P, R);
    EXPECT_LE(r.depth.lower, truth * (1 + 1e-9)) << thin;
    EXPECT_GE(r.depth.upper, truth * (1 - 1e-9)) << thin;
  }
}

// For every pair of kinds: no direction is lower than the lower bound, the normal proves the upper one, and
// the first body out by the depth is apart from the second.
TEST(ObjectDepth, OfEveryPairOfKindsHoldsForAllDirections) {
  Random random(3);
  std::normal_distribution<double> normal;
  ObjectDistanceSolver solver(options()), other(options());
  const Ball Q = euclidean(3);
  const auto bodies = depth_bodies();
  for (const auto& [name_1, A1] : bodies) {
    for (const auto& [name_2, A2] : bodies) {
      SCOPED_TRACE(name_1 + " and " + name_2);
      const Pose pose_1 = random_pose(random, 0), pose_2 = random_pose(random, 0.25);
      const Posed one(*A1, pose_1), two(*A2, pose_2);
      const ObjectDistance& r = solver.solve(one, two, Q, kAll);
      const ObjectDepth& depth = r.depth;
      ASSERT_EQ(r.distance.status, DistanceStatus::contains_origin);
      ASSERT_EQ(depth.status, DistanceStatus::optimal);
      EXPECT_NEAR(depth.normal.norm(), 1, kRounding);
      EXPECT_NEAR(height_of(one, two, depth.normal), depth.upper, kRounding);
      for (int i = 0; i < 300; ++i) {
        const Vector way = sphere_points(3, 1, random);
        const Vector u = (i % 2 == 0 ? way : Vector(depth.normal + 0.01 * way)).normalized();
        EXPECT_GE(height_of(one, two, u), depth.lower - kRounding);
      }
      const Vector between = depth.point_2 - depth.point_1;
      EXPECT_LT((between - depth.depth * depth.normal).norm(), 2 * kTolerance * depth.depth);
      const Pose out(pose_1.rotation(), pose_1.translation() + depth.depth * (1 + 1e-9) * depth.normal);
      const Pose nearly(pose_1.rotation(), pose_1.translation() + 0.999 * depth.depth * depth.normal);
      EXPECT_GE(other.solve({*A1, out}, two, Q).distance.upper, 0);
      EXPECT_GT(other.solve({*A1, out}, two, Q).distance.lower, 0);
      EXPECT_EQ(other.solve({*A1, nearly}, two, Q).distance.lower, 0);
    }
  }
}

TEST(ObjectDepth, IsCertifiedDownToABillionthOfTheSize) {
  Random random(4);
  ObjectDistanceSolver solver(options());
  const auto bodies = depth_bodies();
  for (const auto& [name_1, A1] : bodies) {
    for (const auto& [name_2, A2] : bodies) {
      for (const double planted : {1e-3, 1e-6, 1e-9}) {
        SCOPED_TRACE(name_1 + " and " + name_2 + ", " + std::to_string(planted));
        const Pose pose_1 = random_pose(random, 0);
        Pose pose_2 = random_pose(random, 0);
        const V u = sphere_points(3, 1, random);
        const double height = height_of({*A1, pose_1}, {*A2, pose_2}, u);
        const V a1 = pose_1.apply(A1->support_mapping(-pose_1.rotation().transpose() * u)),
                a2 = pose_2.apply(A2->support_mapping(pose_2.rotation().transpose() * u));
        ASSERT_NEAR(u.dot(a2 - a1), height, kRounding);
        pose_2 = Pose(pose_2.rotation(), pose_2.translation() + a1 - a2 + planted * u);
        const ObjectDistance& r = solver.solve({*A1, pose_1}, {*A2, pose_2}, euclidean(3), kAll);
        if (r.distance.lower > 0) continue;  // a vertex moved out along its own normal
        EXPECT_EQ(r.depth.status, DistanceStatus::optimal);
        EXPECT_LE(r.depth.lower, planted + 1e-14);
      }
    }
  }
}

TEST(ObjectDepth, OfBodiesAboutOnePointIsFoundAmongEqualDirections) {
  ObjectDistanceSolver solver(options());
  const Cylinder A(V(0, 0, -2), V(0, 0, 2), 0.5);
  expect_depth(solver.solve(A, A, euclidean(3), kAll).depth, 1);
  const TruncatedCone cone(V(0, 0, -1), 0.5, V(0, 0, 1), 0.0);
  EXPECT_EQ(solver.solve(cone, cone, euclidean(3), kAll).depth.status, DistanceStatus::optimal);
  const Ellipsoid E(V(0, 0, 0), Eigen::MatrixXd(V(2, 0.5, 0.5).asDiagonal()));
  expect_depth(solver.solve(E, E, euclidean(3), kAll).depth, 1);
}

TEST(ObjectDepth, InThePlane) {
  using P = Eigen::Vector2d;
  ObjectDistanceSolver solver(options());
  const Box square(P(0, 0), P(2, 2)), other(P(1.75, 0.5), P(5, 1));
  const ObjectDistance& r = solver.solve(square, other, euclidean(2), kAll);
  expect_depth(r.depth, 0.25);
  EXPECT_LT((r.depth.normal - P(-1, 0)).norm(), kRounding);
  EXPECT_LT((r.depth.point_2 - r.depth.point_1 - 0.25 * r.depth.normal).norm(), kRounding);
  const Ball disc(P(1, 1.5), 0.75);
  expect_depth(solver.solve(disc, square, euclidean(2), kAll).depth, 1.25);
  const Ellipsoid flat(P(0, 0), Eigen::MatrixXd(P(1, 0.25).asDiagonal()));
  expect_depth(solver.solve(flat, flat, euclidean(2), kAll).depth, 0.5);
  const PointSet triangle((Eigen::MatrixXd(2, 3) << 0, 4, 0, 0, 0, 3).finished());
  const PointSet point(Eigen::MatrixXd(P(1, 1)));
  expect_depth(solver.solve(point, triangle, euclidean(2), kAll).depth, 1);
}

TEST(ObjectDepth, InOtherMetrics) {
  ObjectDistanceSolver solver(options());
  const Box A(V(0, 0, 0), V(2, 3, 4)), B(V(1.5, 2, 2), V(5, 6, 7));
  for (const double p : {1.0, 2.0, 3.0, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(p);
    expect_depth(solver.solve(A, B, PNormBall(V::Zero(), V::Ones(), p), kAll).depth, 0.5);
  }
  // Ways along x cost four times as much.
  const Box metric(V(-0.25, -1, -1), V(0.25, 1, 1));
  const ObjectDistance& r = solver.solve(A, B, metric, kAll);
  expect_depth(r.depth, 1);
  EXPECT_LT((r.depth.normal - V(0, -1, 0)).norm(), kRounding);
  expect_depth(solver.solve(A, B, Ball(V::Zero(), 0.5), kAll).depth, 1);
  expect_depth(solver
                   .solve(Box(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 2)),
                          Box(Eigen::Vector2d(1, 1.5), Eigen::Vector2d(4, 4)),
                          PNormBall(Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones(), 1), kAll)
                   .depth,
               0.5);
}

// A metric that is not symmetric: min h_D(u)/h_Q(u) with D = A2 - A1.
TEST(ObjectDepth, GoesTheCheapWayOfALopsidedMetric) {
  ObjectDistanceSolver solver(options());
  const Box A(V(0, 0, 0), V(1, 1, 1)), Q(V(-0.25, -1, -1), V(4, 1, 1));
  const ObjectDistance& r = solver.solve(A, A, Q, kAll);
  expect_depth(r.depth, 0.25);
  EXPECT_LT((r.depth.normal - V(0.25, 0, 0)).norm(), kRounding);
}

TEST(ObjectDepth, OfSetsKnownByTheirSupportMappingsAlone) {
  ObjectDistanceSolver solver(options());
  const auto ball = std::make_shared<Ball>(V(0, 0, 0), 0.5);
  const auto box = std::make_shared<Box>(V(-1, -1, -1), V(1, 1, 1));
  const MinkowskiSum sum(box, std::make_shared<PNormBall>(V::Zero(), V::Ones(), 3.0));
  expect_depth(solver.solve(sum, *ball, euclidean(3), kAll).depth, 2.5);
  const PNormBall interval(Vector::Zero(1), Vector::Ones(1), 2);
  expect_depth(solver.solve(interval, interval, Ball(Vector::Zero(1), 1.0), kAll).depth, 2);
}

TEST(ObjectDepth, IsNotComputedUnlessItIsAskedForAndThereIsOne) {
  ObjectDistanceSolver solver(options());
  const Ball A(V(0, 0, 0), 1.0), B(V(1, 0, 0), 1.0), C(V(3, 0, 0), 1.0);
  EXPECT_EQ(solver.solve(A, B, euclidean(3), kAll).depth.evaluations, 1);
  for (const auto effects : {ObjectEffects::gradient, kAll}) {
    const ObjectDistance& r = solver.solve(A, effects == kAll ? C : B, euclidean(3), effects);
    EXPECT_EQ(r.depth.evaluations, 0);
    EXPECT_EQ(r.depth.support_queries, 0);
    EXPECT_TRUE(std::isnan(r.depth.depth));
    EXPECT_EQ(r.depth.normal.size(), 0);
    EXPECT_EQ(r.signed_distance(), r.distance.distance);
  }
}

TEST(ObjectDepth, OfBodiesThatTouchIsZeroToRounding) {
  ObjectDistanceSolver solver(options());
  const Box A(V(0, 0, 0), V(1, 1, 1)), B(V(1, 0.25, 0.5), V(2, 2, 2));
  const PointSet C(0.5 * cube_vertices(3)), D((0.5 * cube_vertices(3)).colwise() + V(1, 1, 1));
  for (const ObjectDistance& r : {ObjectDistance(solver.solve(A, B, euclidean(3), kAll)),
                                  ObjectDistance(solver.solve(C, D, euclidean(3), kAll))}) {
    EXPECT_EQ(r.distance.lower, 0);
    EXPECT_EQ(r.depth.lower, 0);
    EXPECT_LE(r.depth.upper, 1e-24);
    EXPECT_LT((r.depth.point_2 - r.depth.point_1).norm(), kRounding);
  }
}

TEST(ObjectDepth, OfFlatBodiesThatCrossIsZero) {
  ObjectDistanceSolver solver(options());
  const PointSet A((Eigen::MatrixXd(3, 2) << -1, 1, 0, 0, 0, 0).finished()),
      B((Eigen::MatrixXd(3, 2) << 0, 0, -1, 1, 0, 0).finished());
  const ObjectDepth& depth = solver.solve(A, B, euclidean(3), kAll).depth;
  EXPECT_EQ(depth.lower, 0);
  EXPECT_LE(depth.upper, 1e-24);
  EXPECT_LT((depth.point_2 - depth.point_1).norm(), kRounding);
}

TEST(ObjectDepth, DoesNotChangeWithTheSizeOfEverything) {
  Random random(6);
  const Eigen::MatrixXd P = gaussian_points(3, 8, random), R = gaussian_points(3, 8, random);
  ObjectDistanceSolver solver(options());
  const ObjectDepth plain = solver.solve(PointSet(P), PointSet(R), euclidean(3), kAll).depth;
  for (const int exponent : {-60, 60}) {
    const double scale = std::ldexp(1.0, exponent);
    const ObjectDepth& r = solver.solve(PointSet(scale * P), PointSet(scale * R), euclidean(3), kAll).depth;
    EXPECT_EQ(r.lower, scale * plain.lower);
    EXPECT_EQ(r.upper, scale * plain.upper);
  }
}

TEST(ObjectDepth, OfAUsedSolverHasTheBitsOfAFreshOne) {
  Random random(7);
  ObjectDistanceSolver used(options());
  const auto bodies = depth_bodies();
  const auto same = [](const Vector& a, const Vector& b) {
    return a.size() == b.size() &&
           (a.size() == 0 ||
            std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
  };
  for (int i = 0; i < 200; ++i) {
    const auto& A1 = bodies[random() % bodies.size()].second;
    const auto& A2 = bodies[random() % bodies.size()].second;
    const Pose pose = random_pose(random, 0.5 * static_cast<double>(i % 3));
    ObjectDistanceSolver fresh(options());
    const ObjectDepth& a = used.solve({*A1, pose}, *A2, euclidean(3), kAll).depth;
    const ObjectDepth& b = fresh.solve({*A1, pose}, *A2, euclidean(3), kAll).depth;
    EXPECT_EQ(a.evaluations, b.evaluations);
    EXPECT_TRUE(a.lower == b.lower || std::isnan(b.lower));
    EXPECT_TRUE(a.upper == b.upper || std::isnan(b.upper));
    EXPECT_TRUE(same(a.normal, b.normal) && same(a.point_1, b.point_1) && same(a.point_2, b.point_2));
  }
}

TEST(ObjectDepth, KeepsATimeLimit) {
  Random random(8);
  const PointSet A(sphere_points(3, 4000, random)), B(sphere_points(3, 4000, random));
  DistanceOptions limited = options(1e-12);
  limited.time_limit = 1e-9;
  ObjectDistanceSolver solver(limited);
  const ObjectDepth& depth = solver.solve(A, B, euclidean(3), kAll).depth;
  EXPECT_EQ(depth.status, DistanceStatus::time_limit);
  EXPECT_LE(depth.lower, 2);
  EXPECT_GE(depth.upper, 1.9);
}

// Of sets that are known by support points in doubles alone: what rounding hides is a part of 1e-13 of the
// size.
TEST(ObjectDepth, OfSetsWithoutCoresIsBoundedBelowAsFarAsRoundingLets) {
  const auto box = std::make_shared<Box>(V(-1, -1, -1), V(1, 1, 1));
  const MinkowskiSum sum(box, std::make_shared<Ball>(V(0, 0, 0), 0.125));
  const Simplex corner(V(0.1, 0.2, 0.3), V(0.7, -0.9, 1.1));  // its vertices are no doubles
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, V(0, 0, 1)).toRotationMatrix();
  ObjectDistanceSolver solver(options());
  for (const double depth : {1e-6, 1e-7, 1e-8, 1e-9, 1e-11}) {
    const Pose above(Eigen::MatrixXd(turn), V(0.1, 0.2, 2.125 - depth));
    const Pose below(Eigen::MatrixXd(turn), V(0.2, 0, -0.7 + depth));
    for (const ObjectDepth& found : {solver.solve({sum}, {*box, above}, euclidean(3), kAll).depth,
                                     solver.solve({*box, below}, {corner}, euclidean(3), kAll).depth}) {
      EXPECT_NEAR(found.lower, depth, 1e-12);
      EXPECT_NEAR(found.upper, depth, 1e-12);
      EXPECT_LE(found.lower, depth + 1e-15);
      EXPECT_GE(found.upper, depth - 1e-15);
      EXPECT_EQ(found.status == DistanceStatus::optimal,
                found.upper - found.lower <= kTolerance * found.upper);
    }
  }
}

TEST(ObjectDepth, InUpToSixDimensionsIsBoundedBelowAsFarAsRoundingLets) {
  ObjectDistanceSolver solver(options());
  for (const int n : {4, 5, 6}) {
    const Box A(-Vector::Ones(n), Vector::Ones(n));
    const PointSet B(cube_vertices(n));
    Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(n, n);
    turn.topLeftCorner(2, 2) = Eigen::Rotation2Dd(0.4).toRotationMatrix();
    for (const double depth : {1e-6, 1e-8, 1e-9, 1e-11}) {
      Vector t = Vector::Constant(n, 0.1);
      t[n - 1] = 2 - depth;
      const ObjectDepth& found = solver.solve({A}, {B, Pose(turn, t)}, euclidean(n), kAll).depth;
      EXPECT_NEAR(found.lower, depth, 1e-12) << n;
      EXPECT_NEAR(found.upper, depth, 1e-12) << n;
    }
  }
}

TEST(ObjectDepth, HasBoundsInLargerSpaces) {
  ObjectDistanceSolver solver(options());
  const Box A(Vector::Zero(7), Vector::Ones(7)), B(Vector::Constant(7, 0.75), Vector::Constant(7, 3));
  const ObjectDepth& depth = solver.solve(A, B, euclidean(7), kAll).depth;
  EXPECT_EQ(depth.status, DistanceStatus::precision_limit);
  EXPECT_EQ(depth.lower, 0);
  EXPECT_NEAR(depth.upper, 0.25, kRounding);
}

}  // namespace
}  // namespace raygauge::test_object_depth
