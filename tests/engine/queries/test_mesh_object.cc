// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/meshes/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "tests/mesh_truth.h"

namespace raygauge::test_mesh_object {
namespace {

using namespace testing;
using Eigen::Vector3d;

const MeshShape kTorus = torus_shape(2, 0.5, 40, 20);
const Ball kUnit(Vector::Zero(3), 1);

Pose moved(double x, double y, double z) {
  return {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Vector3d(x, y, z)};
}

// A half-space is as far from a mesh as from the hull of its vertices, which is a closed form.
TEST(MeshDistance, OfAHalfSpaceIsThatOfTheLowestVertex) {
  std::mt19937_64 random(5);
  const Mesh mesh = mesh_of(torus_shape(2, 0.5, 100, 60), MeshKind::solid);
  const PointSet hull(torus_shape(2, 0.5, 100, 60).vertices);
  MeshDistanceSolver solver;
  ObjectDistanceSolver convex;
  MeshWarmStart warm;
  std::int64_t looks = 0;
  int apart = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Pose at_1 = random_pose(random, 3), at_2 = random_pose(random, 1);
    const HalfSpace floor(random_pose(random, 5).translation(), 3.0 * (trial % 3 - 1));
    const ObjectDistance truth =
        convex.solve({hull, at_1}, {floor, at_2}, kUnit, ObjectEffects::closest_points);
    const ObjectDistance r = solver.solve({mesh, at_1}, {floor, at_2}, ObjectEffects::closest_points, &warm);
    looks += solver.counters().triangle_pairs;
    EXPECT_LE(r.distance.lower, truth.distance.upper);
    EXPECT_GE(r.distance.upper, truth.distance.lower);
    EXPECT_EQ(r.distance.status, truth.distance.status);
    const bool meet = truth.distance.status == DistanceStatus::contains_origin;
    EXPECT_EQ(solver.separation({mesh, at_1}, {floor, at_2}),
              meet ? Separation::intersecting : Separation::separated);
    if (meet) continue;
    ++apart;
    EXPECT_LE((r.distance.normal - truth.distance.normal).norm(), 1e-12);
    EXPECT_NEAR((r.closest_point_1 - r.closest_point_2).norm(), r.distance.distance, 1e-12);
  }
  EXPECT_GT(apart, 40);
  EXPECT_LT(looks, 200 * 40) << "of 12000 triangles each";
}

TEST(MeshDistance, OfAHalfSpaceThatTouchesIsNeverProvenApart) {
  const Mesh box = mesh_of(box_shape(kZero, kOne, 8), MeshKind::solid);
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  MeshDistanceSolver solver;
  const DistanceResult& touching = solver.solve(box, floor).distance;
  EXPECT_EQ(touching.lower, 0);
  EXPECT_LE(touching.upper, 1e-15);
  for (const double height : {1e-3, 1e-9, 1e-14}) {
    const DistanceResult& above = solver.solve({box, moved(0, 0, height)}, floor).distance;
    EXPECT_LE(above.lower, height);
    EXPECT_GE(above.upper, height);
    EXPECT_EQ(above.status, DistanceStatus::optimal) << height;
    EXPECT_EQ(solver.separation({box, moved(0, 0, -height)}, floor), Separation::intersecting) << height;
  }
}

TEST(MeshObject, HasTheDistanceOfItsMeshInBothOrdersAndInBallsOfEverySize) {
  std::mt19937_64 random(6);
  const MeshObject torus(mesh_of(kTorus, MeshKind::solid)), small(mesh_of(box_shape(kZero, kOne, 2)));
  const Box box(-kOne, 0.5 * kOne);
  const HalfSpace floor(Vector3d(0, 0, 1), -4);
  const Ball twice(Vector::Zero(3), 2);
  ObjectDistanceSolver solver;
  GrowthDistanceSolver separation;
  MeshDistanceSolver known;
  WarmStart warm_forth, warm_back;
  const auto effects = ObjectEffects::closest_points | ObjectEffects::gradient;
  for (const ConvexSet* other : std::initializer_list<const ConvexSet*>{&small, &box, &floor}) {
    for (int trial = 0; trial < 30; ++trial) {
      const Pose at_1 = random_pose(random, 2), at_2 = random_pose(random, 1);
      const ObjectDistance truth = known.solve({torus.mesh(), at_1}, {*other, at_2}, effects);
      const ObjectDistance forth = solver.solve({torus, at_1}, {*other, at_2}, kUnit, effects, &warm_forth);
      const ObjectDistance back = solver.solve({*other, at_2}, {torus, at_1}, twice, effects, &warm_back);
      EXPECT_EQ(forth.distance.status, truth.distance.status);
      EXPECT_EQ(back.distance.status, truth.distance.status);
      EXPECT_LE(forth.distance.lower, truth.distance.upper);
      EXPECT_GE(forth.distance.upper, truth.distance.lower);
      EXPECT_LE(2 * back.distance.lower, truth.distance.upper * (1 + 1e-14));
      EXPECT_GE(2 * back.distance.upper, truth.distance.lower * (1 - 1e-14));
      const bool meet = truth.distance.status == DistanceStatus::contains_origin;
      const SeparationResult& apart = separation.separation({*other, at_2}, {torus, at_1});
      EXPECT_EQ(apart.outcome, meet ? Separation::intersecting : Separation::separated);
      EXPECT_EQ(apart.normal.size(), 0);
      if (meet) continue;
      EXPECT_EQ(forth.gradient_evaluations, 1);
      EXPECT_LE((2 * back.gradient_2 - forth.gradient_1).norm(), 1e-5);
      EXPECT_NEAR((forth.closest_point_1 - forth.closest_point_2).norm(), forth.distance.distance, 1e-12);
      EXPECT_NEAR((back.closest_point_1 - back.closest_point_2).norm(), 2 * back.distance.distance, 1e-12);
      EXPECT_LE((back.closest_point_2 - forth.closest_point_1).dot(forth.distance.normal), 1e-5);
    }
  }
}

TEST(MeshObject, IsKnownToBatches) {
  const MeshObject torus(mesh_of(torus_shape(2, 0.5, 200, 100)));
  const Ball ball(Vector::Zero(3), 0.25);
  std::vector<Pose> poses;
  for (int k = 0; k < 8; ++k) poses.push_back(moved(0, 0, 0.5 * k));
  std::vector<PosedPair> pairs;
  for (const Pose& pose : poses) pairs.push_back({{torus, pose}, ball});
  std::vector<double> distances(poses.size());
  BatchAnswers answers;
  answers.distance = distances;
  PairBatch(DistanceOptions(), 2).distances(pairs, kUnit, answers);
  for (std::size_t k = 0; k < poses.size(); ++k)
    EXPECT_NEAR(distances[k], std::hypot(2, poses[k].translation()[2]) - 0.75, 1e-3);
}

template <class Use>
std::string refusal(const Use& use) {
  try {
    use();
  } catch (const InvalidParameterError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(MeshObject, IsRefusedByAllThatConvexSetsHave) {
  const MeshObject torus(mesh_of(kTorus));
  const auto shared = std::make_shared<MeshObject>(mesh_of(kTorus));
  const Box box(-kOne, kOne);
  ObjectDistanceSolver solver;
  const auto names = [](const std::string& text, const char* word) {
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  names(refusal([&] { solver.solve(torus, box, kUnit, ObjectEffects::depth); }), "convex parts");
  names(refusal([&] { solver.solve(torus, box, kUnit, ObjectEffects::pose_gradient); }), "convex parts");
  names(refusal([&] { solver.solve(torus, box, box); }), "Euclidean");
  names(refusal([&] { solver.solve(box, kUnit, torus); }), "not convex");
  names(refusal([&] { GrowthDistanceSolver().solve_about_centers(torus, box); }), "convex parts");
  names(refusal([&] { contains(torus, kZero); }), "not convex");
  names(refusal([&] { torus.center(); }), "not convex");
  names(refusal([&] { torus.support_function(kOne); }), "not convex");
  names(refusal([&] { solver.solve(MinkowskiSum(shared, shared), box, kUnit); }), "not convex");
  names(refusal([&] { MeshDistanceSolver().solve(Posed(box), Posed(box)); }), "neither");
}

/// Against a loop over its balls.
class Cloud : public ::testing::Test {
 protected:
  Cloud() {
    std::mt19937_64 random(3);
    for (int i = 0; i < 60; ++i) points_.col(i) = random_pose(random, 1.5).translation();
  }

  /// Whether `other` in a random pose met it.
  bool agrees(const ConvexSet& other, double radius, std::mt19937_64& random) {
    const MeshObject cloud(Mesh::cloud(points_, radius));
    const Pose at_1 = random_pose(random, 2), at_2 = random_pose(random, 1);
    double lower = std::numeric_limits<double>::infinity(), upper = lower;
    bool meet = false;
    for (const auto& p : points_.colwise()) {
      const Ball ball(Vector(p), radius);
      const DistanceResult& r = loop_.solve({ball, at_1}, {other, at_2}, kUnit).distance;
      meet |= r.status == DistanceStatus::contains_origin;
      lower = std::min(lower, r.lower);
      upper = std::min(upper, r.upper);
    }
    const ObjectDistance& found =
        solver_.solve({cloud, at_1}, {other, at_2}, ObjectEffects::closest_points, &warm_);
    EXPECT_EQ(found.distance.status, meet ? DistanceStatus::contains_origin : DistanceStatus::optimal);
    EXPECT_LE(found.distance.lower, upper);
    EXPECT_GE(found.distance.upper, lower);
    if (!meet) {
      EXPECT_NEAR((found.closest_point_1 - found.closest_point_2).norm(), upper, 1e-5 * upper);
      const Eigen::Vector3d inner =
          at_1.rotation().transpose() * (found.closest_point_1 - at_1.translation());
      EXPECT_NEAR((points_.colwise() - inner).colwise().norm().minCoeff(), radius, 1e-9);
    }
    EXPECT_EQ(solver_.separation({other, at_2}, {cloud, at_1}),
              meet ? Separation::intersecting : Separation::separated);
    return meet;
  }

  Eigen::Matrix3Xd points_{3, 60};
  ObjectDistanceSolver loop_;
  MeshDistanceSolver solver_;
  MeshWarmStart warm_;
};

TEST_F(Cloud, HasTheDistanceOfTheNearestBallFromEveryKindOfObject) {
  std::mt19937_64 random(8);
  const Ball ball(kOne, 0.5);
  const Box box(-kOne, 0.5 * kOne);
  const HalfSpace floor(Vector3d(0, 0, 1), -4);
  const PointSet hull(torus_shape(1, 0.5, 9, 9).vertices);
  const MeshObject torus(mesh_of(torus_shape(2, 0.5, 9, 9))),
      solid(mesh_of(box_shape(-kOne, kOne, 2), MeshKind::solid));
  const MeshObject other(Mesh::cloud(0.3 * points_.leftCols(20), 0.1));
  int met = 0, all = 0;
  for (const ConvexSet* set :
       std::initializer_list<const ConvexSet*>{&ball, &box, &floor, &hull, &torus, &solid, &other}) {
    for (const double radius : {0.0, 1e-3, 0.2}) {
      for (int trial = 0; trial < 20; ++trial, ++all) met += agrees(*set, radius, random) ? 1 : 0;
      warm_.clear();
    }
  }
  EXPECT_GT(met, all / 10);
  EXPECT_LT(met, all * 9 / 10);
}

TEST_F(Cloud, IsInASolidThatHoldsOneOfItsPoints) {
  const Mesh box = mesh_of(box_shape(-kOne, kOne), MeshKind::solid);
  Eigen::Matrix3Xd points(3, 2);
  points << 3, 0, 0, 0, 0, 0;
  EXPECT_EQ(solver_.separation(Mesh::cloud(points, 0.1), box), Separation::intersecting);
  EXPECT_EQ(solver_.separation(box, Mesh::cloud(points.leftCols(1), 1.9)), Separation::separated);
  EXPECT_EQ(solver_.separation(box, Mesh::cloud(points.leftCols(1), 2.1)), Separation::intersecting);
}

TEST_F(Cloud, RefusesWhatHasNoBalls) {
  EXPECT_THROW(Mesh::cloud(Eigen::Matrix3Xd(3, 0), 1), EmptySetError);
  EXPECT_THROW(Mesh::cloud(points_, -1), InvalidParameterError);
  EXPECT_THROW(Mesh::cloud(points_, std::nan("")), InvalidParameterError);
  points_(1, 7) = std::nan("");
  EXPECT_THROW(Mesh::cloud(points_, 1), NonFiniteError);
}

// What is said to meet wherever it is moved meets in random places around.
TEST(MeshDistance, MeetsWhereverItIsMovedOnlyWhereThatHolds) {
  std::mt19937_64 random(12);
  const MeshShape small = box_shape(-0.2 * kOne, 0.2 * kOne, 2), large = box_shape(-kOne, kOne, 3);
  const Mesh one = mesh_of(small), two = mesh_of(large, MeshKind::solid);
  MeshDistanceSolver solver, other;
  int proven = 0, refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Pose at_1 = random_pose(random, 0.6), at_2 = random_pose(random, 0.1);
    const double way = std::exp2(-1 - trial % 30);
    solver.solve({one, at_1}, {two, at_2});
    if (!solver.meets_if_moved(way)) {
      ++refused;
      continue;
    }
    ++proven;
    EXPECT_TRUE(solver.meets_if_moved(0));
    for (int k = 0; k < 20; ++k) {
      const Vector3d step = random_pose(random, 1).translation().normalized() * way;
      const Pose there(at_2.rotation(), at_2.translation() + step);
      EXPECT_EQ(other.separation({one, at_1}, {two, there}), Separation::intersecting);
    }
  }
  EXPECT_GT(proven, 60);
  EXPECT_GT(refused, 60);
  EXPECT_FALSE((solver.solve(one, {two, moved(5, 0, 0)}), solver.meets_if_moved(0))) << "they do not meet";
  EXPECT_FALSE((solver.solve(two, {two, moved(2, 0, 0)}), solver.meets_if_moved(1e-9))) << "they touch";
}

}  // namespace
}  // namespace raygauge::test_mesh_object
