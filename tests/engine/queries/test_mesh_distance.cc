// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/mesh_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/mesh_truth.h"

namespace raygauge::test_mesh_distance {
namespace {

using namespace testing;

constexpr double kTolerance = 1e-6;

void expect_agreement(const ObjectDistance& answer, const BruteForce& truth) {
  const DistanceResult& r = answer.distance;
  EXPECT_LE(r.lower, truth.upper);
  EXPECT_GE(r.upper, truth.lower);
  EXPECT_LE(r.lower, r.upper);
  if (truth.meet) {
    EXPECT_EQ(r.lower, 0);
  } else if (truth.lower > 1e-9) {
    EXPECT_EQ(r.status, DistanceStatus::optimal);
    EXPECT_LE(r.upper - r.lower, kTolerance * r.upper);
  }
}

TEST(MeshDistance, IsThatOfTheNearestTrianglesInRandomPoses) {
  std::mt19937_64 random(7);
  const MeshShape torus = torus_shape(1, 0.3, 9, 5), box = box_shape(-kOne, kOne, 2);
  const Mesh one = mesh_of(torus), two = mesh_of(box);
  MeshDistanceSolver solver;
  for (int trial = 0; trial < 60; ++trial) {
    const Pose at_1 = random_pose(random, 1), at_2 = random_pose(random, trial % 3 == 0 ? 3 : 1.2);
    const BruteForce truth = brute_force(torus, at_1, box, at_2);
    expect_agreement(solver.solve({one, at_1}, {two, at_2}), truth);
    const Separation apart = solver.separation({one, at_1}, {two, at_2});
    EXPECT_EQ(apart, truth.meet ? Separation::intersecting : Separation::separated);
  }
}

RC_GTEST_PROP(MeshDistance, OfWholeNumbersIsThatOfTheNearestTriangles, ()) {
  const auto draw = [] {
    MeshShape mesh;
    const int vertices = *rc::gen::inRange(3, 8), triangles = *rc::gen::inRange(1, 8);
    mesh.vertices.resize(3, vertices);
    for (int i = 0; i < 3 * vertices; ++i) mesh.vertices.data()[i] = *rc::gen::inRange(-3, 4);
    for (int i = 0; i < triangles; ++i)
      mesh.triangles.push_back(
          {*rc::gen::inRange(0, vertices), *rc::gen::inRange(0, vertices), *rc::gen::inRange(0, vertices)});
    return mesh;
  };
  const MeshShape one = draw(), two = draw();
  const Pose at_1(3);
  const Pose at_2(Eigen::Matrix3d(Eigen::Matrix3d::Identity()),
                  Eigen::Vector3d(*rc::gen::inRange(-5, 6), *rc::gen::inRange(-5, 6), 0));
  MeshDistanceSolver solver;
  const ObjectDistance answer = solver.solve({mesh_of(one), at_1}, {mesh_of(two), at_2});
  const BruteForce truth = brute_force(one, at_1, two, at_2);
  RC_ASSERT(answer.distance.lower <= truth.upper);
  RC_ASSERT(answer.distance.upper >= truth.lower);
  RC_ASSERT(!(truth.lower > 0) || answer.distance.status == DistanceStatus::optimal);
  RC_ASSERT(!truth.cross || answer.distance.status == DistanceStatus::contains_origin);
  RC_CLASSIFY(truth.cross, "cross");
  RC_ASSERT(truth.meet || answer.distance.status != DistanceStatus::contains_origin);
}

TEST(MeshDistance, HasPointsOfBothObjectsAndANormalBetweenThem) {
  std::mt19937_64 random(3);
  const MeshShape torus = torus_shape(2, 0.5, 40, 20);
  const Mesh mesh = mesh_of(torus);
  MeshDistanceSolver solver;
  const Pose at_1 = random_pose(random, 1), at_2(random_pose(random, 1).rotation(), Eigen::Vector3d(5, 6, 7));
  const auto effects = ObjectEffects::closest_points | ObjectEffects::gradient;
  const ObjectDistance r = solver.solve({mesh, at_1}, {mesh, at_2}, effects);
  ASSERT_EQ(r.distance.status, DistanceStatus::optimal);
  const Vector way = r.closest_point_1 - r.closest_point_2;
  EXPECT_NEAR(way.norm(), r.distance.distance, 4e-12);  // an upper bound, rounding covered
  EXPECT_NEAR(way.dot(r.distance.normal), r.distance.distance, 1e-6);
  EXPECT_NEAR(r.distance.normal.norm(), 1, 1e-12);
  EXPECT_EQ(r.gradient_1, r.distance.normal);
  const PointSet point_1(r.closest_point_1), point_2(r.closest_point_2);
  EXPECT_LE(solver.solve({mesh, at_1}, Posed(point_1)).distance.lower, 1e-12);
  EXPECT_LE(solver.solve({mesh, at_2}, Posed(point_2)).distance.lower, 1e-12);
}

TEST(MeshDistance, GoesThroughTheHoleOfATorusAndIntoACavity) {
  const Mesh torus = mesh_of(torus_shape(2, 0.5, 256, 128), MeshKind::solid);
  MeshDistanceSolver solver;
  const Ball ball(Vector::Zero(3), 0.25);
  const DistanceResult hole = solver.solve(torus, Posed(ball)).distance;
  EXPECT_NEAR(hole.distance, 1.25, 1e-3);
  EXPECT_EQ(hole.status, DistanceStatus::optimal);
  const Ball in_the_ring(Vector(Eigen::Vector3d(2, 0, 0)), 0.125);
  EXPECT_EQ(solver.solve(torus, Posed(in_the_ring)).distance.status, DistanceStatus::contains_origin);
  EXPECT_EQ(solver.separation(torus, Posed(in_the_ring)), Separation::intersecting);
  const Mesh surface = mesh_of(torus_shape(2, 0.5, 256, 128));
  EXPECT_NEAR(solver.solve(surface, Posed(in_the_ring)).distance.distance, 0.375, 1e-3);

  const Mesh shells =
      mesh_of(joined(box_shape(-3 * kOne, 3 * kOne, 3), box_shape(-kOne, kOne, 2, true)), MeshKind::solid);
  EXPECT_DOUBLE_EQ(shells.volume(), 216 - 8);
  EXPECT_NEAR(solver.solve(shells, Posed(ball)).distance.distance, 0.75, 1e-6);
  const Mesh inner = mesh_of(box_shape(-0.5 * kOne, 0.5 * kOne));
  EXPECT_NEAR(solver.solve(shells, inner).distance.distance, 0.5, 1e-6);
  const Pose in_the_wall(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Eigen::Vector3d(2, 0, 0));
  const Mesh small = mesh_of(box_shape(-0.125 * kOne, 0.125 * kOne));
  EXPECT_EQ(solver.solve(shells, {small, in_the_wall}).distance.status, DistanceStatus::contains_origin);
  EXPECT_EQ(solver.solve({small, in_the_wall}, shells).distance.status, DistanceStatus::contains_origin);
  EXPECT_EQ(solver.separation({small, in_the_wall}, shells), Separation::intersecting);
  EXPECT_EQ(solver.separation(small, shells), Separation::separated);
}

TEST(MeshDistance, FindsEachPartOfAMeshInsideASolid) {
  const Mesh solid = mesh_of(box_shape(kZero, kOne, 4), MeshKind::solid);
  const Mesh two = mesh_of(joined(box_shape(5 * kOne, 6 * kOne), box_shape(0.25 * kOne, 0.5 * kOne)));
  EXPECT_EQ(MeshDistanceSolver().solve(solid, two).distance.status, DistanceStatus::contains_origin);
}

TEST(MeshDistance, OfTouchingMeshesIsUndecidedOrProvenNeverApart) {
  const MeshShape unit = box_shape(kZero, kOne, 2);
  MeshDistanceSolver solver;
  const auto moved = [](double x, double y, double z) {
    return Pose(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Eigen::Vector3d(x, y, z));
  };
  const Mesh box = mesh_of(unit, MeshKind::solid);
  for (const Pose& where : {moved(1, 0, 0), moved(1, 1, 0), moved(1, 1, 1), moved(1, 0.25, 0.3)}) {
    const DistanceResult& r = solver.solve(box, {box, where}).distance;  // faces, edges, corners
    EXPECT_EQ(r.lower, 0);
    EXPECT_LE(r.upper, 1e-12);
    EXPECT_NE(solver.separation(box, {box, where}), Separation::separated);
  }
  for (const double gap : {1e-3, 1e-7, 1e-11, 0x1p-50}) {
    const DistanceResult& r = solver.solve(box, {box, moved(1 + gap, 0.25, 0.3)}).distance;
    EXPECT_LE(r.lower, gap * (1 + 1e-3) + 0x1p-52);
    EXPECT_GE(r.upper, gap * (1 - 1e-3) - 0x1p-52);
    EXPECT_NE(r.status, DistanceStatus::contains_origin);
    EXPECT_TRUE(gap < 1e-12 || r.status == DistanceStatus::optimal) << gap;
  }
}

TEST(MeshDistance, OfThinPlatesAndNeedlesThatCrossIsZero) {
  const Mesh plate = mesh_of(box_shape({-1, -1, -1e-9}, {1, 1, 1e-9}, 8), MeshKind::solid);
  MeshShape needle;
  needle.vertices.resize(3, 3);
  needle.vertices << 0.1, 0.1, 0.1 + 1e-9, 0.2, 0.2, 0.2, -1, 1, 1;
  needle.triangles = {{0, 1, 2}};
  MeshDistanceSolver solver;
  EXPECT_EQ(solver.solve(plate, mesh_of(needle)).distance.status, DistanceStatus::contains_origin);
  const Pose above(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Eigen::Vector3d(0, 0, 1 + 2e-9));
  const DistanceResult& r = solver.solve(plate, {mesh_of(needle), above}).distance;
  EXPECT_EQ(r.status, DistanceStatus::optimal);
  EXPECT_NEAR(r.distance, 1e-9, 1e-12);
}

TEST(MeshDistance, AgreesWithThatOfConvexObjectsOfEveryKind) {
  std::mt19937_64 random(11);
  const MeshShape shape = box_shape(-kOne, kOne, 3);
  const Mesh mesh = mesh_of(shape, MeshKind::solid);
  const Box box(-kOne, kOne);
  std::vector<std::unique_ptr<ConvexSet>> bodies;
  bodies.push_back(std::make_unique<Ball>(Vector(Eigen::Vector3d(0.1, 0.2, 0.3)), 0.5));
  bodies.push_back(std::make_unique<Box>(Eigen::Vector3d(-1, -2, -0.1), Eigen::Vector3d(1, 2, 0.1)));
  bodies.push_back(std::make_unique<Capsule>(Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(1, 1, 0), 0.3));
  bodies.push_back(std::make_unique<Ellipsoid>(Vector::Zero(3), Eigen::Matrix3d::Identity()));
  bodies.push_back(std::make_unique<PointSet>(torus_shape(2, 0.5, 9, 9).vertices));
  bodies.push_back(std::make_unique<PNormBall>(Vector::Zero(3), 0.7 * kOne, 4.0));
  ObjectDistanceSolver convex;
  MeshDistanceSolver solver;
  const Ball unit(Vector::Zero(3), 1);
  for (int trial = 0; trial < 90; ++trial) {
    const ConvexSet& body = *bodies[static_cast<std::size_t>(trial) % bodies.size()];
    const Pose at_1 = random_pose(random, 1), at_2 = random_pose(random, 2);
    const DistanceResult truth = convex.solve({box, at_1}, {body, at_2}, unit).distance;
    const DistanceResult& r = solver.solve({mesh, at_1}, {body, at_2}).distance;
    EXPECT_LE(r.lower, truth.upper);
    EXPECT_GE(r.upper, truth.lower);
    EXPECT_EQ(r.status, truth.status);
    const Separation apart = solver.separation({mesh, at_1}, {body, at_2});
    EXPECT_EQ(apart == Separation::intersecting, truth.status == DistanceStatus::contains_origin);
  }
}

// The search in single precision and the one for sizes beyond it.
TEST(MeshDistance, OfEverySizeAndInstructionSetIsTheSame) {
  std::mt19937_64 random(19);
  const MeshShape torus = torus_shape(1, 0.3, 14, 9), box = box_shape(-kOne, kOne, 5);
  for (int trial = 0; trial < 30; ++trial) {
    const Pose at_1 = random_pose(random, 1), at_2 = random_pose(random, trial % 3 == 0 ? 3 : 1.2);
    const BruteForce truth = brute_force(torus, at_1, box, at_2);
    for (const InstructionSet isa : instruction_sets_here()) {
      DistanceOptions options;
      options.instruction_set = isa;
      MeshDistanceSolver solver(options);
      for (const int exponent : {-60, -21, -16, 0, 16, 23, 60}) {
        const double scale = std::ldexp(1.0, exponent);
        const auto scaled = [&](const MeshShape& shape) {
          return Mesh(shape.vertices * scale, shape.triangles);
        };
        const auto moved = [&](const Pose& at) { return Pose(at.rotation(), at.translation() * scale); };
        const Mesh one = scaled(torus), two = scaled(box);
        const Pose there_1 = moved(at_1), there_2 = moved(at_2);
        ObjectDistance answer = solver.solve({one, there_1}, {two, there_2});
        answer.distance.lower /= scale;
        answer.distance.upper /= scale;
        expect_agreement(answer, truth);
        const Separation apart = solver.separation({one, there_1}, {two, there_2});
        EXPECT_EQ(apart, truth.meet ? Separation::intersecting : Separation::separated) << exponent;
      }
    }
  }
}

TEST(MeshDistance, FromTheLastTrianglesIsTheSameAndLooksAtFewerBoxes) {
  const Mesh mesh = mesh_of(torus_shape(2, 0.5, 100, 50));
  MeshDistanceSolver solver;
  MeshWarmStart warm;
  std::int64_t cold_looks = 0, warm_looks = 0;
  for (int i = 0; i < 40; ++i) {
    const Pose where(Eigen::AngleAxisd(0.01 * i, Eigen::Vector3d::UnitX()).matrix(),
                     Eigen::Vector3d(0.02 * i, 4, 1));
    const DistanceResult cold = solver.solve(mesh, {mesh, where}).distance;
    cold_looks += solver.counters().triangle_pairs;
    const DistanceResult& hot = solver.solve(mesh, {mesh, where}, ObjectEffects::none, &warm).distance;
    warm_looks += solver.counters().triangle_pairs;
    EXPECT_LE(std::fabs(hot.distance - cold.distance), kTolerance * cold.upper);
    EXPECT_LE(hot.lower, cold.upper);
    EXPECT_GE(hot.upper, cold.lower);
  }
  EXPECT_LT(warm_looks, cold_looks);
  warm.triangle_1 = 1 << 30;  // of no use, and no harm
  EXPECT_EQ(
      solver.solve(mesh, mesh_of(torus_shape(1, 0.1, 4, 4)), ObjectEffects::none, &warm).distance.status,
      DistanceStatus::optimal);
}

TEST(MeshDistance, KeepsTimeLimitsAndSaysWhatIsProvenByThen) {
  DistanceOptions options;
  options.time_limit = 1e-9;
  MeshDistanceSolver solver(options);
  const Mesh inner = mesh_of(torus_shape(2, 0.5, 200, 100)), outer = mesh_of(torus_shape(2, 0.625, 200, 100));
  const DistanceResult& r = solver.solve(inner, outer).distance;  // as far apart everywhere
  EXPECT_EQ(r.status, DistanceStatus::time_limit);
  EXPECT_LE(r.lower, 0.125);
  EXPECT_GE(r.upper, 0.12);
}

TEST(MeshDistance, RefusesWhatIsNotDefined) {
  const Mesh mesh = mesh_of(box_shape(kZero, kOne));
  MeshDistanceSolver solver;
  EXPECT_THROW(solver.solve(mesh, mesh, ObjectEffects::depth), InvalidParameterError);
  const Ball flat(Vector::Zero(2), 1);
  EXPECT_THROW(solver.solve(mesh, Posed(flat)), DimensionMismatchError);
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  EXPECT_THROW(MeshDistanceSolver{options}, InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_mesh_distance
