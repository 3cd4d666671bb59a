// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_finder.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_contact_finder {
namespace {

using Eigen::Vector3d;

const Box kBox(Vector3d(-0.3, -0.2, -0.1), Vector3d(0.3, 0.2, 0.1));
const Ball kBall(Vector3d(0, 0, 0), 0.25);

// A ball touches a corner, an edge and a face: the point is where the ball is, not a far corner of the box.
TEST(ContactFinder, a_ball_touches_a_box_in_one_point) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Pose at_box(turn, Vector3d(1, 2, 3));
  ContactFinder finder;
  PartContact contact;
  for (const Vector3d& way : {Vector3d(1, 2, 3), Vector3d(0, 1, 1), Vector3d(0, 0, 1)}) {
    const Vector3d u = way.normalized();
    const Vector3d corner(way[0] > 0 ? 0.3 : 0.07, way[1] > 0 ? 0.2 : 0.05, 0.1);
    for (const double gap : {3.6e-7, 1e-12, -3.6e-7}) {
      const Vector3d center = turn * (corner + (0.25 + gap) * u) + Vector3d(1, 2, 3);
      const Pose at_ball(Eigen::Matrix3d(turn.transpose()), center);
      finder.find({kBox, at_box}, {kBall, at_ball}, 1e-5, Vector3d::UnitX(), contact);
      ASSERT_EQ(contact.points.size(), 1U) << way.transpose() << " " << gap;
      EXPECT_LE((contact.points[0].at - (turn * corner + Vector3d(1, 2, 3))).norm(), 1e-6);
      EXPECT_NEAR(contact.points[0].gap, gap, 1e-9);
      EXPECT_LE((contact.normal + turn * u).norm(), 1e-5);
    }
  }
}

// The rim of a cylinder, tilted a little: eight corners of its disc miss the deepest point.
TEST(ContactFinder, the_deepest_point_of_a_rim_is_among_those_found) {
  const Cylinder cylinder(Vector3d(0, 0, -0.3), Vector3d(0, 0, 0.3), 0.5);
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  for (const double turn : {0.01, 0.2, 0.39}) {
    const Eigen::Matrix3d R =
        (Eigen::AngleAxisd(0.05, Vector3d::UnitX()) * Eigen::AngleAxisd(turn, Vector3d::UnitZ()))
            .toRotationMatrix();
    for (const double gap : {1e-7, -1e-7}) {
      const Pose pose(R, Vector3d(0, 0, gap + 0.3 * std::cos(0.05) + 0.5 * std::sin(0.05)));
      ContactFinder finder(1e-8);
      PartContact contact;
      finder.find({cylinder, pose}, {floor}, 0.05, Vector3d::UnitX(), contact);
      double least = 1;
      for (const GapPoint& point : contact.points) least = std::min(least, point.gap);
      EXPECT_NEAR(contact.lower, gap, 1e-12);
      EXPECT_NEAR(least, gap, 1e-8);
    }
  }
}

// Gaps of a face on a face are linear in the place, to the last digits.
TEST(ContactFinder, four_corners_of_a_face_have_consistent_gaps) {
  const Box floor(Vector3d(-5, -5, -1), Vector3d(5, 5, 0));
  ContactFinder finder;
  PartContact contact;
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Vector3d::UnitZ()) * Eigen::AngleAxisd(1e-7, Vector3d::UnitX()))
          .toRotationMatrix();
  const Pose at_box(turn, Vector3d(0.1, 0.2, 0.1 + 1e-6));
  finder.find({kBox, at_box}, {floor}, 1e-5, Vector3d::UnitX(), contact);
  ASSERT_EQ(contact.points.size(), 4U);
  Eigen::Matrix4d rows;
  Eigen::Vector4d gaps;
  for (int k = 0; k < 4; ++k) {
    const GapPoint& point = contact.points[static_cast<std::size_t>(k)];
    rows.row(k) << 1, point.at[0], point.at[1], 0;
    gaps[k] = point.gap;
    EXPECT_NEAR(point.gap,
                (turn * (turn.transpose() * (point.at - Vector3d(0.1, 0.2, 0.1 + 1e-6))))[2] + 0.1 + 1e-6,
                1e-6);
  }
  const Eigen::Vector4d linear = rows * rows.completeOrthogonalDecomposition().solve(gaps);
  EXPECT_LE((linear - gaps).lpNorm<Eigen::Infinity>(), 1e-15);
}

// A half-space, turned and moved, on either side: four corners of the box, each as far above the plane as it
// stands.
TEST(ContactFinder, a_box_stands_on_a_half_space_on_four_corners) {
  const HalfSpace floor(Vector3d(0, 0, 2), 1.0);  // z <= 0.5
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Pose at_floor(turn, Vector3d(3, -1, 2));
  ContactFinder finder;
  PartContact contact;
  for (const double gap : {2e-6, 0.0, -2e-6}) {
    const Pose at_box(turn, Vector3d(turn * Vector3d(0.7, 40, 0.6 + gap) + Vector3d(3, -1, 2)));
    for (const bool floor_first : {false, true}) {
      if (floor_first) {
        finder.find({floor, at_floor}, {kBox, at_box}, 1e-5, Vector3d::UnitX(), contact);
      } else {
        finder.find({kBox, at_box}, {floor, at_floor}, 1e-5, Vector3d::UnitX(), contact);
      }
      ASSERT_EQ(contact.points.size(), 4U) << gap;
      for (const GapPoint& point : contact.points) EXPECT_NEAR(point.gap, gap, 1e-13);
      EXPECT_LE((contact.normal - (floor_first ? -1 : 1) * turn.col(2)).norm(), 1e-12);
      EXPECT_LE(contact.lower, gap + 1e-13);
      EXPECT_GE(contact.lower, gap - 1e-11);
      EXPECT_NEAR(contact.overlap, std::max(0.0, -gap), 1e-11);
    }
  }
}

TEST(ContactFinder, a_square_stands_on_a_half_plane_on_two_corners) {
  const HalfSpace floor(Eigen::Vector2d(0, 1), 0.0);
  const Box square(Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1));
  ContactFinder finder;
  PartContact contact;
  finder.find(square, floor, 1e-5, Vector3d::UnitX(), contact);
  ASSERT_EQ(contact.points.size(), 2U);
  EXPECT_NEAR((contact.points[0].at - contact.points[1].at).norm(), 2, 1e-12);
  EXPECT_LE((contact.normal - Vector3d::UnitY()).norm(), 1e-12);
}

TEST(ContactFinder, bodies_farther_apart_than_the_band_have_no_points) {
  ContactFinder finder;
  PartContact contact;
  const Pose away(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Vector3d(0, 0, 0.36));
  finder.find({kBox}, {kBall, away}, 1e-3, Vector3d::UnitX(), contact);
  EXPECT_TRUE(contact.points.empty());
  EXPECT_NEAR(contact.lower, 0.01, 1e-9);
}

// Its ends have different gaps; the line between the points is across the normal even so.
TEST(ContactFinder, points_of_one_pair_lie_in_one_plane_across_the_normal) {
  const Capsule capsule(Vector3d(-0.5, 0, 0), Vector3d(0.5, 0, 0), 0.25);
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  const Pose pose(Eigen::Quaterniond(Eigen::AngleAxisd(1e-3, Vector3d::UnitY())), Vector3d(0, 0, 0.2506));
  ContactFinder finder;
  PartContact contact;
  finder.find({capsule, pose}, {floor}, 0.01, Vector3d::UnitX(), contact);
  ASSERT_EQ(contact.points.size(), 2U);
  EXPECT_GT(std::abs(contact.points[0].gap - contact.points[1].gap), 5e-4);
  EXPECT_LE(std::abs(contact.normal.dot(contact.points[0].at - contact.points[1].at)), 1e-15);
}

}  // namespace
}  // namespace raygauge::test_contact_finder
