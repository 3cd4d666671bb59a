// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A point next to a face, an edge or a corner of a box in a pose, against rational arithmetic.
#include "engine/methods/spatial/inner_ball.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/random_poses.h"
#include "tests/engine/rational.h"

namespace raygauge::test_inner_ball {
namespace {

using Eigen::Vector3d;
using testing::gaussian;
using testing::Random;
using Exact3 = BasicVector3<Rational>;

const Vector3d kHalf(0.6, 0.5, 0.4);

Exact3 exact(const Vector3d& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

// Whether p is in the interior of the box of half edges kHalf in the pose, by Cramer's rule.
bool is_inside(const Pose& pose, const Exact3& p) {
  const Exact3 way = p - exact(pose.translation());
  const Exact3 column[3] = {exact(pose.rotation().col(0)), exact(pose.rotation().col(1)),
                            exact(pose.rotation().col(2))};
  const Rational determinant = dot(column[0], cross(column[1], column[2]));
  for (int k = 0; k < 3; ++k) {
    const Rational y = dot(way, cross(column[(k + 1) % 3], column[(k + 2) % 3])) / determinant;
    if (abs(y) >= Rational(kHalf[k])) return false;
  }
  return true;
}

// A box and a point whose nearest face has the first `corners` of three corners of the box, one side, and the
// point of it with these weights is `depth` from the point, a depth along each axis across the face.
struct Contact {
  Contact(Random& random, int corners, const Vector3d& depth)
      : box(-kHalf, kHalf),
        pose(Eigen::Quaterniond(Eigen::AngleAxisd(3 * gaussian(random)[0], gaussian(random).normalized())),
             gaussian(random)) {
    std::uniform_real_distribution<double> share(0.2, 0.5);
    const double second = corners > 1 ? share(random) : 0.0, third = corners > 2 ? share(random) : 0.0;
    const Vector3d in_box = (1 - second - third) * corner(0) + second * corner(1) + third * corner(2);
    Vector3d inward = depth;
    for (int k = 0; k + 1 < corners; ++k) inward[k] = 0;
    point = pose.rotation() * (in_box - inward) + pose.translation();
  }

  // Of three corners along the axes x and y of the side z = kHalf_z.
  static Vector3d corner(int i) {
    return {i == 1 ? -kHalf[0] : kHalf[0], i == 2 ? -kHalf[1] : kHalf[1], kHalf[2]};
  }

  Box box;
  Pose pose;
  Vector3d point;
};

bool claims_overlap(const Contact& contact) {
  const PointSet other(contact.point);
  SpatialPair pair;
  EXPECT_TRUE(pair.bind(contact.box, other, InstructionSet::automatic));
  EXPECT_TRUE(pair.place(PoseNumbers(&contact.pose), PoseNumbers()));
  PrecisePair precise;
  EXPECT_TRUE(precise.bind(pair));
  return inner_ball(pair, precise, {}, 0) > 0;
}

// The origin is in D where the point is in the box.
TEST(InnerBall, IsClaimedOfPointsInsideAndOfNoOthers) {
  Random random(53);
  int inside = 0, claimed = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    Vector3d depth;
    for (double& along : depth) {
      along = std::pow(10.0, -12 - static_cast<int>(random() % 5)) * (random() % 6 == 0 ? -1 : 1);
    }
    const Contact contact(random, 1 + trial % 3, depth);
    const bool claim = claims_overlap(contact), truth = is_inside(contact.pose, exact(contact.point));
    ASSERT_LE(claim, truth) << "trial " << trial;
    inside += truth ? 1 : 0;
    claimed += claim ? 1 : 0;
  }
  EXPECT_GT(inside, 2000);
  EXPECT_EQ(claimed, inside);
}

}  // namespace
}  // namespace raygauge::test_inner_ball
