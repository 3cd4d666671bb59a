// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/truncated_cone.h"

// Cylinders and cones of the plane: rectangles, triangles and trapezoids whose corners no doubles have.
namespace raygauge::test_planar_frusta {
namespace {

using P = Eigen::Vector2d;

Pose at(const P& t) { return {Eigen::MatrixXd(Eigen::Matrix2d::Identity()), t}; }

// A rectangle of width 2 and length 3 along `way`, its lower side through the origin of the pose.
Cylinder rectangle(const P& way) { return {P(0, 0), 3 * way.normalized(), 1.0}; }

ObjectDistance solve(const Posed& A1, const Posed& A2, ObjectEffects effects) {
  DistanceOptions options;
  options.tolerance = 1e-6;
  return ObjectDistanceSolver(options).solve(A1, A2, Ball(Vector::Zero(2), 1.0), effects);
}

TEST(PlanarFrusta, ShallowDepthsAreCertified) {
  const Box ground(P(-10, -10), P(10, 0));
  for (const double depth : {1e-9, 3e-9, 1e-8, 1e-7, 1e-3, 0.5}) {
    const ObjectDistance r = solve({ground}, {rectangle(P(0, 1)), at(P(0.3, -depth))}, ObjectEffects::depth);
    ASSERT_EQ(r.depth.status, DistanceStatus::optimal) << depth;
    EXPECT_LE(r.depth.lower, depth * (1 + 1e-14));
    EXPECT_GE(r.depth.upper, depth * (1 - 1e-14));
    EXPECT_NEAR(std::fabs(r.depth.normal[1]), 1, 1e-12);
    EXPECT_EQ(r.depth.normal.size(), 2);
  }
}

// The corner p + a_⊥ of a rectangle along a = (1, 2)/√5 is at height 1/√5 above p.
TEST(PlanarFrusta, CornersThatAreRoundedReachIn) {
  const Box ground(P(-10, -10), P(10, 0));
  const Cylinder body(P(0, 0), P(1, 2), 1.0);
  const double below = 1 / std::sqrt(5.0);  // the lowest corner is this far below p
  for (const double depth : {2e-9, 1e-6, 0.01}) {
    const ObjectDistance r = solve({ground}, {body, at(P(0, below - depth))}, ObjectEffects::depth);
    ASSERT_EQ(r.depth.status, DistanceStatus::optimal) << depth;
    EXPECT_NEAR(r.depth.depth, depth, 1e-6 * depth + 4e-16);
    EXPECT_NEAR(r.depth.point_2[1], -depth, 1e-6 * depth + 1e-15);
  }
}

TEST(PlanarFrusta, DistancesAndGrowthAreThoseOfTheTrapezoid) {
  const TruncatedCone wedge(P(0, 0), 1.0, P(4, 0), 2.0);
  const Ball ball(P(4.5, 0), 0.25);
  const ObjectDistance r = solve({wedge}, {ball}, ObjectEffects::closest_points);
  EXPECT_NEAR(r.distance.distance, 0.25, 1e-12);
  EXPECT_NEAR(r.closest_point_1[0], 4, 1e-9);
  const Box box(P(1, 3), P(2, 4));
  // The side from (0, 1) to (4, 2) is nearest to the corner (2, 3).
  const double side = ((-2 + 4 * 3) - 4) / std::sqrt(17.0);  // -x + 4 y is 4 along it
  const DistanceResult between = solve({wedge}, {box}, ObjectEffects::none).distance;
  EXPECT_LE(between.lower, side * (1 + 1e-15));
  EXPECT_GE(between.upper, side * (1 - 1e-15));
  EXPECT_EQ(between.status, DistanceStatus::optimal);
  EXPECT_GT(GrowthDistanceSolver().solve({wedge}, {box}).distance, 1);
}

TEST(PlanarFrusta, ContactsOfAFlatEndAreItsTwoCorners) {
  const Box ground(P(-10, -10), P(10, 0));
  ContactPatchSolver solver;
  for (const double gap : {0.0, 1e-5, -1e-5}) {
    const Cylinder body(P(0, 0), P(0, 3), 1.0);
    const ContactPatch& patch = solver.solve({ground}, {body, at(P(0.5, gap))}, 1e-3);
    ASSERT_EQ(patch.count, 2) << gap;
    const double left = std::min(patch.points[0].point_2.x, patch.points[1].point_2.x);
    const double right = std::max(patch.points[0].point_2.x, patch.points[1].point_2.x);
    EXPECT_NEAR(left, -0.5, 1e-11);
    EXPECT_NEAR(right, 1.5, 1e-11);
    for (const ContactPoint& p : patch.contacts()) {
      EXPECT_EQ(p.point_1.z, 0);
      EXPECT_EQ(p.point_2.z, 0);
      EXPECT_NEAR(p.gap, gap, 1e-12);
    }
  }
}

TEST(PlanarFrusta, ContactsOfALongSideAreItsTwoCorners) {
  const Box ground(P(-10, -10), P(10, 0));
  const Cylinder body(P(0, 1), P(3, 1), 1.0);
  ContactPatchSolver solver;
  const ContactPatch& patch = solver.solve({ground}, {body}, 1e-3);
  ASSERT_EQ(patch.count, 2);
  EXPECT_NEAR(std::fabs(patch.points[0].point_2.x - patch.points[1].point_2.x), 3, 1e-12);
}

TEST(PlanarFrusta, GradientsByPoseAreThoseOfTheCorner) {
  const Box ground(P(-10, -10), P(10, 0));
  const Cylinder body(P(0, 0), P(1, 2), 1.0);
  const ObjectDistance r = solve({ground}, {body, at(P(0, 1))}, ObjectEffects::pose_gradient);
  ASSERT_EQ(r.pose_gradient.kind, GradientKind::unique);
  // The lowest corner is (2, -1)/√5 from the origin of the pose.
  EXPECT_NEAR(r.pose_gradient.body_2.linear.y, 1, 1e-9);
  EXPECT_NEAR(r.pose_gradient.body_2.angular.z, 2 / std::sqrt(5.0), 1e-9);
  EXPECT_NEAR(r.pose_gradient.body_2.angular.x, 0, 1e-12);
}

}  // namespace
}  // namespace raygauge::test_planar_frusta
