// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/round_pair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_round_pair {
namespace {

using V = Eigen::Vector3d;
using SetPointer = std::shared_ptr<const ConvexSet>;
using Random = std::mt19937_64;

constexpr double kNoise = 1e-11;  // of bodies and ways of size 10 at most

V gaussian(Random& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

Pose random_pose(Random& random, double way) {
  const V axis = gaussian(random).normalized();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(gaussian(random).norm(), axis)), way * gaussian(random)};
}

Eigen::MatrixXd turned_axes(const V& half) {
  return Eigen::AngleAxisd(0.7, V(1, -2, 3).normalized()).toRotationMatrix() * half.asDiagonal();
}

std::vector<SetPointer> cores() {
  const V p(0.1, -0.2, 0.3), q(0.4, 0.9, -0.2);
  return {std::make_shared<Ball>(p, 0.4),
          std::make_shared<Capsule>(p, q, 0.3),
          std::make_shared<Capsule>(p, q, 0.0),
          std::make_shared<Box>(V(-0.6, -0.9, -0.1), V(0.9, 0.8, 0.7)),
          std::make_shared<Cylinder>(p, q, 0.8),
          std::make_shared<TruncatedCone>(p, 0.9, q, 0.2),
          std::make_shared<TruncatedCone>(p, 0.0, q, 1.5),
          std::make_shared<Ellipsoid>(p, Eigen::MatrixXd(V(1.2, 0.5, 0.8).asDiagonal())),
          std::make_shared<Ellipsoid>(p, turned_axes({0.7, 0.7, 0.2})),
          std::make_shared<Ellipsoid>(q, turned_axes({1e-3, 0.9, 1e-3}))};
}

struct Case {
  const ConvexSet* set[2];
  Pose pose[2];

  // min u·x over the first body - max u·x over the second: at most the signed distance.
  double apart_along(const V& u) const {
    const double first = set[0]->support_function(pose[0].rotation().transpose() * -u);
    const double second = set[1]->support_function(pose[1].rotation().transpose() * u);
    return -first + u.dot(pose[0].translation()) - second - u.dot(pose[1].translation());
  }
};

V dense(const Vector3& v) { return {v.x, v.y, v.z}; }

// The greatest gap along any of many directions, and a search around the best.
double widest_gap(const Case& at, Random& random) {
  V best = V::UnitX();
  double gap = at.apart_along(best), reach = 1;
  for (int i = 0; i < 600; ++i) {
    const V u = (i < 200 ? gaussian(random) : V(best + reach * gaussian(random))).normalized();
    const double other = at.apart_along(u);
    if (other > gap) {
      gap = other;
      best = u;
    }
    if (i > 200 && i % 20 == 0) reach *= 0.5;
  }
  return gap;
}

// False where there is no formula, too.
bool solve(const ConvexSet& first, const ConvexSet& second, const PoseNumbers& pose_1,
           const PoseNumbers& pose_2, RoundPair& pair) {
  const SpatialShape &one = *first.spatial_shape(), &two = *second.spatial_shape();
  return RoundPair::with(RoundPair::formula(one, two), [&]<RoundPair::Formula kFormula>() {
    pair.solve<kFormula>(one, two, pose_1, pose_2);
    return pair.is_known;
  });
}

void expect_true(const Case& at, const std::string& name, Random& random) {
  RoundPair pair{};
  if (!solve(*at.set[0], *at.set[1], PoseNumbers(&at.pose[0]), PoseNumbers(&at.pose[1]), pair)) return;
  EXPECT_LE(pair.upper - pair.lower, kNoise) << name;
  const V n = dense(pair.normal);
  EXPECT_NEAR(n.norm(), 1, 1e-14) << name;
  EXPECT_NEAR(at.apart_along(n), pair.lower, kNoise) << name;
  EXPECT_LE(widest_gap(at, random), pair.upper) << name;
  const V way = dense(pair.point_1) - dense(pair.point_2);
  EXPECT_LE((way - pair.upper * n).norm(), kNoise) << name;
  for (int i = 0; i < 2; ++i) {
    const V x = dense(i == 0 ? pair.point_1 : pair.point_2), u = i == 0 ? V(-n) : n;
    const double height = at.set[i]->support_function(at.pose[i].rotation().transpose() * u);
    EXPECT_NEAR(u.dot(x), height + u.dot(at.pose[i].translation()), kNoise) << name << ", point " << i + 1;
  }
}

TEST(RoundPair, ProvesTheSignedDistanceOfEveryPairThatHasAFormula) {
  Random random(3);
  const std::vector<SetPointer> sets = cores();
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (std::size_t b = 0; b < sets.size(); ++b) {
      for (int i = 0; i < 40; ++i) {
        const Case at{{sets[a].get(), sets[b].get()},
                      {random_pose(random, 1), random_pose(random, i % 2 == 0 ? 0.3 : 1.0)}};
        expect_true(at, std::to_string(a) + " " + std::to_string(b) + " case " + std::to_string(i), random);
      }
    }
  }
}

// On the axis, next to it, at the centre, on the middle plane of a box.
TEST(RoundPair, KnowsTheWayOutOfPlacesWhereTwoAreAsShort) {
  Random random(4);
  const Cylinder cylinder(V(0, 0, -1), V(0, 0, 1), 0.5);
  const TruncatedCone cone(V(0, 0, -1), 1.5, V(0, 0, 1), 0.0);
  const Box box(V(-1, -1, -1), V(1, 1, 1));
  for (const ConvexSet* set : {static_cast<const ConvexSet*>(&cylinder), static_cast<const ConvexSet*>(&cone),
                               static_cast<const ConvexSet*>(&box)}) {
    for (const double off : {0.0, 1e-300, 1e-17, 1e-12, 1e-6}) {
      for (const double height : {0.0, -0.4, -0.9}) {
        const Ball ball(V(off, -off, height), 0.25);
        for (const bool swapped : {false, true}) {
          const Case at{{swapped ? &ball : set, swapped ? set : &ball}, {Pose(3), Pose(3)}};
          expect_true(at, std::to_string(off) + " " + std::to_string(height), random);
        }
      }
    }
  }
}

// Whatever the axis: what rounding leaves of the way from it may be along it.
TEST(RoundPair, KnowsTheWayOutFromTheAxisItself) {
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const V base = gaussian(random), top = base + gaussian(random);
    const TruncatedCone cone(base, std::abs(gaussian(random).x()), top, i % 2 == 0 ? 0.0 : 0.3);
    const double share = std::uniform_real_distribution<double>(0, 1)(random);
    const Ball ball(base + share * (top - base), 0.25);
    expect_true({{&cone, &ball}, {Pose(3), Pose(3)}}, "case " + std::to_string(i), random);
  }
  // Rounding leaves a short vector along the axis (found by raygauge_soak depths).
  const V end = V::Constant(0.57735026918962584);
  const TruncatedCone cone(end, 0.52438824698456932, -end, 1);
  const Ball ball(V::Zero(), 0.25);
  expect_true({{&cone, &ball}, {Pose(3), Pose(3)}}, "end", random);
}

// From the plane across the shortest axis there are two ways out, from the middle of a ball or a disc all;
// far outside; on the surface; and axes that are not at right angles have no formula.
TEST(RoundPair, KnowsTheWayOutOfEllipsoids) {
  Random random(7);
  const Ball ball(V::Zero(), 0.25);
  for (const V& half : {V(1, 0.5, 0.8), V(1, 1, 1), V(0.5, 0.5, 1), V(0.5, 1, 1), V(1e-5, 1, 0.3)}) {
    const Ellipsoid ellipsoid(V::Zero(), turned_axes(half));
    const Eigen::Matrix3d R = turned_axes(V::Ones());
    for (const V& share : {V(0, 0, 0), V(0.3, 0, 0), V(0, 0.2, 0.1), V(0, 0, 0.6), V(0.9, 0, 0),
                           V(0, 1e-12, 0.1), V(1, 1e-20, 0), V(0, 3, 0), V(5, 7, -9), V(0.6, 0.8, 0)}) {
      const Pose at(Eigen::Matrix3d::Identity(), R * half.cwiseProduct(share));
      for (const bool swapped : {false, true}) {
        const Case pair{{swapped ? static_cast<const ConvexSet*>(&ball) : &ellipsoid,
                         swapped ? static_cast<const ConvexSet*>(&ellipsoid) : &ball},
                        {swapped ? at : Pose(3), swapped ? Pose(3) : at}};
        RoundPair found{};
        EXPECT_TRUE(
            solve(*pair.set[0], *pair.set[1], PoseNumbers(&pair.pose[0]), PoseNumbers(&pair.pose[1]), found));
        expect_true(pair, std::to_string(half.x()) + " " + std::to_string(share.x()), random);
      }
    }
  }
  Eigen::Matrix3d skew = Eigen::Matrix3d::Identity();
  skew(0, 1) = 0.1;
  RoundPair found{};
  EXPECT_FALSE(solve(Ellipsoid(V::Zero(), skew), ball, {}, {}, found));
}

// A hair outside, where Newton's steps may end inside.
TEST(RoundPair, OfPointsOnEllipsoidsHasBoundsThatAgree) {
  Random random(7);
  std::uniform_real_distribution<double> power(-1.7, 0.7), hair(-15, -11);
  const Ball point(V::Zero(), 0.0);
  for (int i = 0; i < 20000; ++i) {
    const V half(std::pow(10, power(random)), std::pow(10, power(random)), std::pow(10, power(random)));
    const Pose at(Eigen::Matrix3d::Identity(),
                  half.cwiseProduct(gaussian(random).normalized()) * (1 + std::pow(10, hair(random))));
    RoundPair found{};
    solve(Ellipsoid(V::Zero(), Eigen::MatrixXd(half.asDiagonal())), point, {}, PoseNumbers(&at), found);
    EXPECT_LE(found.lower, found.upper);
  }
}

// On the shortest axis, of half length a, y from the middle: a - y. Farther out than a - b²/a on the longest.
TEST(RoundPair, OfABallInAnEllipsoidIsTheKnownWayAlongAnAxis) {
  const Ellipsoid ellipsoid(V::Zero(), Eigen::MatrixXd(V(2, 1, 1.5).asDiagonal()));
  const Ball metric(V::Zero(), 1);
  ObjectDistanceSolver solver;
  const auto depth = [&](const V& at) {
    return solver.solve(Ball(at, 0.5), ellipsoid, metric, ObjectEffects::depth).depth.depth;
  };
  EXPECT_NEAR(depth(V(0, 0.3, 0)), 0.7 + 0.5, kNoise);
  EXPECT_NEAR(depth(V(1.8, 0, 0)), 0.2 + 0.5, kNoise);
  EXPECT_NEAR(depth(V(0, 0, 0)), 1 + 0.5, kNoise);
}

// Of a ball in a cone of half angle atan(1/2) about its axis: the way to the side is (tip - z) sin.
TEST(RoundPair, OfABallInAConeIsTheWayToTheSideAndTheRadius) {
  const TruncatedCone cone(V(0, 0, 0), 1, V(0, 0, 2), 0);
  const Ball ball(V(0, 0, 1), 0.5), metric(V::Zero(), 2);
  ObjectDistanceSolver solver;
  const ObjectDistance& r = solver.solve(cone, ball, metric, ObjectEffects::depth);
  EXPECT_NEAR(r.depth.depth, (1 / std::sqrt(5.0) + 0.5) / 2, kNoise);
  EXPECT_LE(r.depth.lower, r.depth.upper);
  EXPECT_EQ(r.depth.status, DistanceStatus::optimal);
  EXPECT_EQ(r.distance.status, DistanceStatus::contains_origin);
  EXPECT_NEAR(r.depth.normal.norm(), 0.5, 1e-15);
}

// Where two ways out are as short, or two pairs of points as near, others look for all of them.
TEST(RoundPair, HasAGradientWhereThereIsOneShortestWay) {
  const Box box(V(-1, -2, -3), V(1, 2, 3));
  const Cylinder cylinder(V(0, 0, -2), V(0, 0, 2), 1);
  const Capsule along_x(V(-1, 0, 0), V(1, 0, 0), 0.1), along_y(V(0, -1, 2), V(0, 1, 2), 0.1),
      beside(V(-1, 0, 2), V(1, 0, 2), 0.1);
  const Ball metric(V::Zero(), 1);
  ObjectDistanceSolver solver;
  const auto kind = [&](const ConvexSet& one, const ConvexSet& two) {
    return solver.solve(one, two, metric, ObjectEffects::depth | ObjectEffects::pose_gradient)
        .pose_gradient.kind;
  };
  EXPECT_EQ(kind(box, Ball(V(0.5, 0, 0), 0.3)), GradientKind::unique);
  EXPECT_EQ(kind(box, Ball(V(0.5, -1.5, 0), 0.3)), GradientKind::one_sided);
  EXPECT_EQ(kind(Ball(V(0, 0, 2.5), 0.3), cylinder), GradientKind::unique);
  EXPECT_EQ(kind(cylinder, Ball(V(0.5, 0.3, 0), 0.3)), GradientKind::unique);
  EXPECT_NE(kind(cylinder, Ball(V(0, 0, 0), 0.3)), GradientKind::unique);
  EXPECT_NE(kind(cylinder, Ball(V(0.5, 0, 1.5), 0.3)), GradientKind::unique);
  const Ellipsoid ellipsoid(V::Zero(), Eigen::MatrixXd(V(2, 1, 1.5).asDiagonal()));
  EXPECT_EQ(kind(ellipsoid, Ball(V(0.5, 0.2, 0), 0.3)), GradientKind::unique);
  EXPECT_NE(kind(ellipsoid, Ball(V(0.5, 0, 0.1), 0.3)), GradientKind::unique);
  EXPECT_EQ(kind(along_x, along_y), GradientKind::unique);
  EXPECT_EQ(kind(along_x, beside), GradientKind::one_sided);
}

TEST(RoundPair, SaysNothingWhereRoundingHidesTheDirection) {
  const Capsule one(V(-1, 0, 0), V(1, 0, 0), 0.5), two(V(0, -1, 0), V(0, 1, 0), 0.5);
  RoundPair pair{};
  EXPECT_FALSE(solve(one, two, {}, {}, pair));
  ObjectDistanceSolver solver;
  const Ball metric(V::Zero(), 1);
  const ObjectDistance& r = solver.solve(one, two, metric, ObjectEffects::depth);
  EXPECT_NEAR(r.depth.depth, 1, 1e-6);
  EXPECT_EQ(r.depth.status, DistanceStatus::optimal);
}

}  // namespace
}  // namespace raygauge::test_round_pair
