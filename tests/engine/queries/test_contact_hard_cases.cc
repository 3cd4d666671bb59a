// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Depths and contact patches with closed forms where rounding or ties decide.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_contact_hard_cases {
namespace {

using V = Eigen::Vector3d;
constexpr double kRounding = 1e-12;  // of bodies of size 1

V of(const Vector3& v) { return {v.x, v.y, v.z}; }

Pose turned(double angle, const V& axis, const V& t) {
  return {Eigen::MatrixXd(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()), t};
}
Pose at(const V& t) { return {Eigen::MatrixXd(Eigen::Matrix3d::Identity()), t}; }

void expect_depth(const Posed& one, const Posed& two, double truth) {
  ObjectDistanceSolver solver;
  const Ball Q(Vector::Zero(3), 1.0);
  const ObjectDepth& depth = solver.solve(one, two, Q, ObjectEffects::depth).depth;
  EXPECT_EQ(depth.status, DistanceStatus::optimal) << truth;
  EXPECT_LE(depth.lower, truth * (1 + 1e-9) + kRounding * truth);
  EXPECT_GE(depth.upper, truth * (1 - 1e-9));
  EXPECT_LE(depth.upper - depth.lower, 1e-6 * depth.upper);
}

// Parallel cylinders: D is a cylinder of both radii and both heights.
TEST(ContactHardCases, DepthOfRimOnRimIsTheLesserOfTwoWays) {
  const Cylinder can(V(0, 0, 0), V(0, 0, 1), 0.5);
  for (const double side : {1e-2, 1e-3, 1e-6}) {
    for (const double up : {side * 2, side, side * (1 + 1e-15), side * 0.5})
      expect_depth({can}, {can, at(V(0.6 * (1 - side), 0.8 * (1 - side), 1 - up))}, std::min(side, up));
  }
}

TEST(ContactHardCases, DepthOfAConeWithItsApexInsideIsThatOfTheApex) {
  const TruncatedCone cone(V(0, 0, 1), 0.5, V(0, 0, 0), 0.0);
  const Box floor(V(-5, -5, -2), V(5, 5, 0));
  for (const double deep : {0.25, 1e-3, 1e-9}) expect_depth({floor}, {cone, at(V(0.25, 0.5, -deep))}, deep);
}

TEST(ContactHardCases, DepthOfCrossedEdgesIsAlongBoth) {
  const Box beam(V(-2, -1, -1), V(2, 1, 1)), other(V(-1, -2, -1), V(1, 2, 1));
  const double top = std::sqrt(2.0);
  for (const double deep : {1e-2, 1e-5, 1e-8}) {
    const Pose below = turned(M_PI / 4, V(1, 0, 0), V(0, 0, 0)),
               above = turned(M_PI / 4, V(0, 1, 0), V(0.125, 0.0625, 2 * top - deep));
    ObjectDistanceSolver solver;
    const ObjectDepth& depth =
        solver.solve({beam, below}, {other, above}, Ball(Vector::Zero(3), 1.0), ObjectEffects::depth).depth;
    EXPECT_NEAR(depth.upper, deep, 1e-15 + 1e-6 * deep);
    EXPECT_LE(depth.lower, deep + 1e-15);
    EXPECT_LT((V(depth.normal) - V(0, 0, -1)).norm(), 1e-6);
  }
}

TEST(ContactHardCases, DepthOfASmallBodyInALargeOneIsTheWayToTheNearestFace) {
  const Box crate(V(-100, -100, -100), V(100, 100, 100)), grain(V(-1e-3, -1e-3, -1e-3), V(1e-3, 1e-3, 1e-3));
  expect_depth({crate}, {grain, at(V(99, -50, 3))}, 1 + 1e-3);
  expect_depth({crate}, {grain, at(V(25, 25, -25))}, 75 + 1e-3);  // three equal ways
}

TEST(ContactHardCases, PatchOfAFaceTurnedByRoundingIsTheWholeFace) {
  ContactPatchSolver solver;
  const Box cube(V(-1, -1, 0), V(1, 1, 2)), floor(V(-5, -5, -1), V(5, 5, 0));
  for (const V& axis : {V(1, 0, 0), V(1, 2, 0), V(0, 0, 1)}) {
    for (const double gap : {1e-3, -1e-3}) {
      const ContactPatch& patch = solver.solve({floor}, {cube, turned(1e-12, axis, V(0, 0, gap))}, 2e-3);
      ASSERT_EQ(patch.count, 4);
      for (const ContactPoint& p : patch.contacts()) {
        EXPECT_NEAR(std::fabs(p.point_2.x), 1, 1e-11);
        EXPECT_NEAR(std::fabs(p.point_2.y), 1, 1e-11);
        EXPECT_NEAR(p.gap, gap, 1e-11);
      }
    }
  }
}

TEST(ContactHardCases, PatchOfWhatHangsOverAnEdgeEndsThere) {
  ContactPatchSolver solver;
  const Box table(V(0, 0, -1), V(4, 4, 0)), plate(V(-1, -1, 0), V(1, 1, 0.5));
  const ContactPatch patch = solver.solve({table}, {plate, at(V(3.75, 3.5, 0.01))}, 0.02);
  ASSERT_EQ(patch.count, 4);
  for (const ContactPoint& p : patch.contacts()) {
    EXPECT_TRUE(std::fabs(p.point_2.x - 2.75) < kRounding || std::fabs(p.point_2.x - 4) < kRounding);
    EXPECT_TRUE(std::fabs(p.point_2.y - 2.5) < kRounding || std::fabs(p.point_2.y - 4) < kRounding);
  }
  const Cylinder can(V(0, 0, 0), V(0, 0, 1), 0.5);
  const ContactPatch& disc = solver.solve({table}, {can, at(V(4, 2, 0.01))}, 0.02);
  ASSERT_GE(disc.count, 5);
  double farthest = 0;
  for (const ContactPoint& p : disc.contacts()) {
    EXPECT_LE(p.point_1.x, 4 + kRounding);
    EXPECT_LE((of(p.point_2) - V(4, 2, 0.01)).norm(), 0.5 + kRounding);
    farthest = std::max(farthest, std::fabs(p.point_2.y - 2));
  }
  EXPECT_NEAR(farthest, 0.5, 0.01);
}

// A cube is tilted about an edge, then about a corner: of its face four corners are within the margin, then
// two, then one.
TEST(ContactHardCases, PatchOfATiltingCubeBecomesAnEdgeAndThenAVertex) {
  ContactPatchSolver solver;
  const Box cube(V(0, 0, 0), V(1, 1, 1)), floor(V(-5, -5, -1), V(5, 5, 0));
  constexpr double kMargin = 1e-3, kAtMargin = 1e-9;
  constexpr int kSteps = 101;
  WarmStart warm;
  for (int i = 0; i <= 2 * kSteps; ++i) {
    const double first = 2e-3 * std::min(i, kSteps) / kSteps,
                 second = 5e-3 * std::max(i - kSteps, 0) / kSteps;
    const Eigen::Matrix3d R =
        (Eigen::AngleAxisd(second, V(1, 0, 0)) * Eigen::AngleAxisd(-first, V(0, 1, 0))).toRotationMatrix();
    int within = 0;
    for (const V& corner : {V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(1, 1, 0)})
      within += (R * corner).z() <= kMargin + kAtMargin ? 1 : 0;
    const ContactPatch& patch =
        solver.solve({floor}, {cube, {Eigen::MatrixXd(R), V(0, 0, 0)}}, kMargin, &warm);
    ASSERT_EQ(patch.count, within) << i;
    for (const ContactPoint& p : patch.contacts()) {
      const V x = R.transpose() * of(p.point_2);
      EXPECT_LT(std::min(std::fabs(x.x()), std::fabs(x.x() - 1)), 1e-9) << i;
      EXPECT_LT(std::min(std::fabs(x.y()), std::fabs(x.y() - 1)), 1e-9) << i;
      EXPECT_NEAR(p.gap, p.point_2.z, 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace raygauge::test_contact_hard_cases
