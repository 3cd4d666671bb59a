// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/queries/depth_cases.h"

namespace raygauge::test_contact_patch {
namespace {

using V = Eigen::Vector3d;
constexpr double kRounding = 1e-12;  // of bodies of size 1
constexpr double kProven = 1e-11;    // what is proven of that

V of(const Vector3& v) { return {v.x, v.y, v.z}; }

Pose turned(const V& axis, double angle, const V& t) {
  return {Eigen::MatrixXd(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()), t};
}
Pose at(const V& t) { return {Eigen::MatrixXd(Eigen::Matrix3d::Identity()), t}; }

Box floor_box(double size = 1) { return {size * V(-5, -5, -1), size * V(5, 5, 0)}; }

// The largest distance of a point of one patch from the nearest of the other.
double change(const ContactPatch& a, const ContactPatch& b) {
  double most = a.count == b.count ? 0 : INFINITY;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const ContactPoint& p : one->contacts()) {
      double least = INFINITY;
      for (const ContactPoint& q : other->contacts())
        least =
            std::min(least, (of(p.point_1) - of(q.point_1)).norm() + (of(p.point_2) - of(q.point_2)).norm());
      most = std::max(most, least);
    }
  }
  return most;
}

// Each of `expected` is the point on the second body of one pair, and there are no others.
void expect_points(const ContactPatch& patch, const std::vector<V>& expected, double tolerance = kRounding) {
  ASSERT_EQ(patch.count, static_cast<int>(expected.size()));
  for (const V& x : expected) {
    double least = INFINITY;
    for (const ContactPoint& p : patch.contacts()) least = std::min(least, (of(p.point_2) - x).norm());
    EXPECT_LE(least, tolerance) << x.transpose();
  }
}

TEST(ContactPatch, OfSquaresTurnedByAnEighthIsAnOctagon) {
  ContactPatchSolver solver;
  const Box cube(V(-1, -1, 0), V(1, 1, 2));
  const ContactPatch& patch = solver.solve({Box(V(-1, -1, -2), V(1, 1, 0))},
                                           {cube, turned(V(0, 0, 1), M_PI / 4, V(0, 0, 0.01))}, 0.05);
  const double s = std::sqrt(2.0) - 1, z = 0.01;
  expect_points(patch, {V(1, s, z), V(1, -s, z), V(-1, s, z), V(-1, -s, z), V(s, 1, z), V(-s, 1, z),
                        V(s, -1, z), V(-s, -1, z)});
  EXPECT_LT((of(patch.normal) - V(0, 0, 1)).norm(), kRounding);
  for (const ContactPoint& p : patch.contacts()) {
    EXPECT_NEAR(p.gap, 0.01, kRounding);
    EXPECT_NEAR(p.point_1.z, 0, kRounding);
  }
  EXPECT_LT(patch.error, kProven);
}

TEST(ContactPatch, OfBodiesThatTouchOrOverlapHasGapsOfTheirOwn) {
  ContactPatchSolver solver;
  const Box cube(V(-1, -1, -1), V(1, 1, 1)), floor = floor_box();
  for (const double gap : {0.0, -1e-3, -1e-9}) {
    const ContactPatch& patch = solver.solve({floor}, {cube, at(V(0.5, 0, 1 + gap))}, 1e-6);
    expect_points(patch, {V(1.5, 1, gap), V(1.5, -1, gap), V(-0.5, 1, gap), V(-0.5, -1, gap)});
    for (const ContactPoint& p : patch.contacts()) EXPECT_NEAR(p.gap, gap, kRounding);
  }
}

// A cube that is tilted about an edge by a little: gaps grow with the distance from it, and the face is cut
// where they reach the margin.
TEST(ContactPatch, OfATiltedFaceIsCutAtTheMargin) {
  ContactPatchSolver solver;
  const Box cube(V(0, -1, 0), V(2, 1, 2)), floor = floor_box();
  const double angle = 1e-3;
  const auto tilted = turned(V(0, 1, 0), -angle, V(0, 0, 0.001));
  for (const double margin : {0.01, 0.0025}) {
    const ContactPatch& patch = solver.solve({floor}, {cube, tilted}, margin);
    ASSERT_EQ(patch.count, 4 - (margin < 0.003 ? 2 : 0));
    for (const ContactPoint& p : patch.contacts()) {
      EXPECT_NEAR(p.gap, 0.001 + p.point_2.x * std::tan(angle), kRounding);
      EXPECT_LE(p.gap, margin + kRounding);
    }
    EXPECT_LT(patch.error, kProven);
  }
}

TEST(ContactPatch, OfAStandingCylinderIsAnOctagonOfItsDisc) {
  ContactPatchSolver solver;
  const Cylinder can(V(0, 0, 0), V(0, 0, 2), 0.5);
  const ContactPatch& patch = solver.solve({floor_box()}, {can, at(V(1, 1, 0.01))}, 0.02);
  ASSERT_EQ(patch.count, 8);
  double area = 0;
  for (int i = 0; i < 8; ++i) {
    const V p = of(patch.points[static_cast<std::size_t>(i)].point_2) - V(1, 1, 0.01),
            q = of(patch.points[static_cast<std::size_t>((i + 1) % 8)].point_2) - V(1, 1, 0.01);
    EXPECT_NEAR(p.norm(), 0.5, kRounding);
    EXPECT_NEAR(0.5 - (0.5 * (p + q)).norm(), 0.5 * (1 - std::cos(M_PI / 8)), 1e-9);
    area += 0.5 * p.cross(q).norm();
  }
  EXPECT_NEAR(area, 0.25 * 4 * std::sin(M_PI / 4), 1e-9);
}

TEST(ContactPatch, OfWhatLiesAlongALineHasItsEnds) {
  ContactPatchSolver solver;
  const Capsule rod(V(-1, 0, 0), V(1, 0, 0), 0.25);
  expect_points(solver.solve({floor_box()}, {rod, at(V(0, 0, 0.26))}, 0.02), {V(-1, 0, 0.01), V(1, 0, 0.01)});
  const Cylinder can(V(-1, 0, 0), V(1, 0, 0), 0.25);
  expect_points(solver.solve({floor_box()}, {can, at(V(0, 0, 0.26))}, 0.02), {V(-1, 0, 0.01), V(1, 0, 0.01)},
                1e-8);
  const Capsule beside(V(0, 0, 0), V(3, 0, 0), 0.5);
  const ContactPatch& patch = solver.solve({beside}, {rod, at(V(0, 0, 0.75))}, 0.01);
  expect_points(patch, {V(0, 0, 0.5), V(1, 0, 0.5)}, 1e-9);
}

TEST(ContactPatch, OfAnEdgeHasTwoPointsAndOfAVertexOne) {
  ContactPatchSolver solver;
  const Box cube(V(-1, -1, -1), V(1, 1, 1)), floor = floor_box();
  const double r = std::sqrt(2.0);
  expect_points(solver.solve({floor}, {cube, turned(V(0, 1, 0), M_PI / 4, V(0, 0, r))}, 1e-3),
                {V(0, 1, 0), V(0, -1, 0)}, 1e-9);
  const Pose on_corner(Eigen::MatrixXd(Eigen::Quaterniond::FromTwoVectors(V(1, 1, 1), V(0, 0, -1)).matrix()),
                       V(0, 0, std::sqrt(3.0)));
  expect_points(solver.solve({floor}, {cube, on_corner}, 1e-3), {V(0, 0, 0)}, 1e-9);
  const Pose crossing(
      Eigen::MatrixXd((Eigen::AngleAxisd(M_PI / 2, V(0, 0, 1)) * Eigen::AngleAxisd(M_PI / 4, V(0, 1, 0)))
                          .toRotationMatrix()),
      V(0.25, 0.25, 2 * r));
  const ContactPatch& patch =
      solver.solve({cube, turned(V(0, 1, 0), M_PI / 4, V(0, 0, 0))}, {cube, crossing}, 1e-3);
  expect_points(patch, {V(0, 0.25, r)}, 1e-9);
}

// Whatever of the other body is within the margin.
TEST(ContactPatch, OfAVertexAboveAnEdgeIsTheirClosestPair) {
  Eigen::MatrixXd points(3, 4);
  points << 0, 5, -5, 0,  //
      0, 5, 5, -5,        //
      0, 20, 20, 20;
  const Box cube(V(-1, -1, -1), V(1, 1, 1));
  const PreparedSet needle(points);
  const V n = V(1, 0, 1).normalized();
  ContactPatchSolver solver;
  const ContactPatch& patch =
      solver.solve({cube}, {needle, turned(V(0, 1, 0), M_PI / 4, V(1, 0, 1) + 0.5 * n)}, 3);
  expect_points(patch, {V(1, 0, 1) + 0.5 * n});
  EXPECT_LT((of(patch.points[0].point_1) - V(1, 0, 1)).norm(), kRounding);
  EXPECT_NEAR(patch.points[0].gap, 0.5, kRounding);
  EXPECT_LE(patch.error, kProven);
}

TEST(ContactPatch, OfABallIsOnePoint) {
  ContactPatchSolver solver;
  const Ball ball(V(0, 0, 0), 0.5);
  expect_points(solver.solve({floor_box()}, {ball, at(V(1, 2, 0.49))}, 0), {V(1, 2, -0.01)});
  expect_points(solver.solve({Ball(V(0, 0, -1), 1.0)}, {ball, at(V(0, 0, 0.5))}, 0.1), {V(0, 0, 0)});
}

TEST(ContactPatch, ScalesWithTheBodies) {
  ContactPatchSolver solver;
  for (const double size : {1e-6, 1e6}) {
    const Box cube(size * V(-1, -1, -1), size * V(1, 1, 1));
    const ContactPatch& patch =
        solver.solve({floor_box(size)}, {cube, at(size * V(0, 0, 1.001))}, size * 0.01);
    ASSERT_EQ(patch.count, 4);
    for (const ContactPoint& p : patch.contacts()) EXPECT_NEAR(p.gap, 0.001 * size, kRounding * size);
    EXPECT_LT(patch.error, kProven * size);
  }
}

TEST(ContactPatch, OfNeedlesHasTheirCorners) {
  ContactPatchSolver solver;
  const Box needle(V(-1, -1e-6, -1e-6), V(1, 1e-6, 1e-6)), floor = floor_box();
  const ContactPatch& patch = solver.solve({floor}, {needle, at(V(0, 0, 1.5e-6))}, 1e-6);
  expect_points(patch, {V(1, 1e-6, 5e-7), V(1, -1e-6, 5e-7), V(-1, 1e-6, 5e-7), V(-1, -1e-6, 5e-7)});
  const Pose across = turned(V(0, 0, 1), M_PI / 2, V(0.25, 0, 2.5e-6));
  EXPECT_EQ(solver.solve({needle}, {needle, across}, 1e-6).count, 4);
}

TEST(ContactPatch, InThePlaneHasUpToTwoPoints) {
  using V2 = Eigen::Vector2d;
  ContactPatchSolver solver;
  const Box low(V2(0, -1), V2(4, 0)), high(V2(1, 0.01), V2(6, 2));
  expect_points(solver.solve({low}, {high}, 0.1), {V(1, 0.01, 0), V(4, 0.01, 0)});
  expect_points(solver.solve({low}, {Ball(V2(2, 1.01), 1.0)}, 0.1), {V(2, 0.01, 0)});
}

TEST(ContactPatch, OfOtherSetsIsFoundByTheirSupportMappings) {
  ContactPatchSolver solver;
  Eigen::MatrixXd normals(6, 3);
  normals << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  const HPolytope cube(normals, Vector::Ones(6));
  const ContactPatch& patch = solver.solve({floor_box()}, {cube, at(V(0, 0, 1.01))}, 0.05);
  expect_points(patch, {V(1, 1, 0.01), V(1, -1, 0.01), V(-1, 1, 0.01), V(-1, -1, 0.01)}, 1e-9);
}

// Bodies that rest on each other as they fall: from every pair of kinds in random poses.
struct Resting {
  std::shared_ptr<const ConvexSet> A1, A2;
  Pose pose_1{3}, pose_2{3};
  std::string names;
};

std::vector<Resting> resting_pairs(double gap) {
  Random random(71);
  ObjectDistanceSolver distance;
  std::vector<Resting> all;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      for (const bool parallel : {false, true}) {
        Resting pair{A1, A2, random_pose(random, 0.5), random_pose(random, 2.5), name_1 + " " + name_2};
        if (parallel)
          pair.pose_2 = Pose(pair.pose_1.rotation(),
                             pair.pose_1.translation() + pair.pose_1.rotation() * V(0.1, 0.2, 3));
        const ObjectDistance& r =
            distance.solve({*A1, pair.pose_1}, {*A2, pair.pose_2}, Ball(Vector::Zero(3), 1.0));
        const Vector way = r.distance.normal * (r.distance.distance - gap);
        pair.pose_2 = Pose(pair.pose_2.rotation(), pair.pose_2.translation() + way);
        all.push_back(pair);
      }
    }
  }
  return all;
}

// How far x is from the surface of a body, by its distance and depth.
double off_surface(const V& x, const Posed& body) {
  ObjectDistanceSolver solver;
  const Ball Q(Vector::Zero(3), 1.0), point(x, 0.0);
  return std::fabs(solver.solve(Posed(point), body, Q, ObjectEffects::depth).signed_distance());
}

TEST(ContactPatch, OfEveryPairOfKindsIsOnBothSurfaces) {
  ContactPatchSolver solver;
  for (const double gap : {1e-4, -1e-4}) {
    for (const Resting& pair : resting_pairs(gap)) {
      const Posed A1{*pair.A1, pair.pose_1}, A2{*pair.A2, pair.pose_2};
      const ContactPatch& patch = solver.solve(A1, A2, 1e-3);
      ASSERT_GE(patch.count, 1) << pair.names;
      EXPECT_LT(patch.error, 2e-3) << pair.names;
      double least = INFINITY;
      for (const ContactPoint& p : patch.contacts()) {
        EXPECT_LE(off_surface(of(p.point_1), A1), patch.error + kRounding) << pair.names;
        EXPECT_LE(off_surface(of(p.point_2), A2), patch.error + kRounding) << pair.names;
        EXPECT_NEAR(p.gap, of(patch.normal).dot(of(p.point_2) - of(p.point_1)), kRounding) << pair.names;
        EXPECT_LE(p.gap, 1e-3 + kRounding) << pair.names;
        least = std::min(least, p.gap);
      }
      EXPECT_NEAR(least, patch.upper, 1.1e-5) << pair.names;
      EXPECT_NEAR(patch.upper, gap, 1e-4) << pair.names;
    }
  }
}

// To the tolerance or a billionth of the margin: of bodies that touch less is computed, and is as true.
TEST(ContactPatch, BoundsOfBodiesThatTouchAreThoseOfTheirDistanceOrDepth) {
  constexpr double kMargin = 1e-3;
  ContactPatchSolver solver;
  DistanceOptions fine;
  fine.tolerance = 1e-9;
  ObjectDistanceSolver distances(fine);
  const Ball ball(V(0, 0, 0), 1);
  for (const double gap : {1e-5, 1e-7, 1e-10, 1e-13, -1e-13, -1e-10, -1e-7, -1e-5}) {
    for (const Resting& pair : resting_pairs(gap)) {
      const Posed A1{*pair.A1, pair.pose_1}, A2{*pair.A2, pair.pose_2};
      const ContactPatch& patch = solver.solve(A1, A2, kMargin);
      const ObjectDistance& found =
          distances.solve(A1, A2, ball, ObjectEffects::closest_points | ObjectEffects::depth);
      const bool apart = found.distance.lower > 0;
      const double lower = apart ? found.distance.lower : -found.depth.upper,
                   upper = apart ? found.distance.upper : -found.depth.lower;
      EXPECT_LE(patch.lower, upper) << pair.names << ' ' << gap;
      EXPECT_GE(patch.upper, lower) << pair.names << ' ' << gap;
      EXPECT_LE(patch.upper - patch.lower, upper - lower + 1e-9 * kMargin) << pair.names << ' ' << gap;
    }
  }
}

TEST(ContactPatch, MovesLittleWhereBodiesMoveLittle) {
  ContactPatchSolver solver;
  constexpr double kStep = 1e-9;
  std::vector<Resting> pairs = resting_pairs(1e-4);
  const std::vector<Resting> overlapping = resting_pairs(-1e-4);
  pairs.insert(pairs.end(), overlapping.begin(), overlapping.end());
  for (const Resting& pair : pairs) {
    const Pose step = turned(V(1, 2, 3), kStep, kStep * V(1, -1, 1));
    WarmStart kept;
    for (WarmStart* const warm : {static_cast<WarmStart*>(nullptr), &kept}) {
      const ContactPatch before = solver.solve({*pair.A1, pair.pose_1}, {*pair.A2, pair.pose_2}, 1e-3, warm);
      const ContactPatch& after =
          solver.solve({*pair.A1, pair.pose_1}, {*pair.A2, step.after(pair.pose_2)}, 1e-3, warm);
      EXPECT_LT(change(before, after), 1e-4) << pair.names << ' ' << before.count << ' ' << after.count;
    }
  }
}

TEST(ContactPatch, OfBodiesFartherApartThanTheMarginIsEmpty) {
  ContactPatchSolver solver;
  const Ball ball(V(0, 0, 0), 0.5);
  const ContactPatch& patch = solver.solve({floor_box()}, {ball, at(V(0, 0, 1))}, 0.4);
  EXPECT_EQ(patch.count, 0);
  EXPECT_EQ(patch.status, DistanceStatus::optimal);
  EXPECT_NEAR(patch.lower, 0.5, 1e-8);
}

TEST(ContactPatch, RefusesWhatItDoesNotTake) {
  ContactPatchSolver solver;
  const Ball one(V(0, 0, 0), 0.5), flat(Eigen::Vector2d(0, 0), 0.5), four(Vector::Zero(4), 0.5);
  EXPECT_THROW(solver.solve({one}, {one}, -1), InvalidParameterError);
  EXPECT_THROW(solver.solve({one}, {one}, std::nan("")), InvalidParameterError);
  EXPECT_THROW(solver.solve({four}, {four}, 0.1), InvalidParameterError);
  EXPECT_THROW(solver.solve({one}, {flat}, 0.1), DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::test_contact_patch
