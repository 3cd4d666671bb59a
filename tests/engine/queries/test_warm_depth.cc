// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Depths and contact patches from a warm start.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/queries/body_depth.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/queries/depth_cases.h"

namespace raygauge::test_warm_depth {
namespace {

using V = Eigen::Vector3d;
constexpr auto kWanted = ObjectEffects::depth | ObjectEffects::closest_points;
constexpr double kRootOfTolerance = 1e-4;  // of patches, 1e-9, times the size: what normals may be off by
const Ball& euclidean() {
  static const Ball kBall(Vector::Zero(3), 1.0);
  return kBall;
}

Pose step(const V& axis, double angle, const V& way) {
  return {Eigen::MatrixXd(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()), way};
}

// Both enclose the same depth, to the tolerance.
void expect_same(const ObjectDepth& warm, const ObjectDepth& cold, const std::string& names) {
  EXPECT_EQ(warm.status, DistanceStatus::optimal) << names;
  EXPECT_LE(warm.lower, cold.upper) << names;
  EXPECT_GE(warm.upper, cold.lower) << names;
}

TEST(WarmDepth, IsAskedForBeforeTheDistance) {
  Random random(61);
  ObjectDistanceSolver solver, fresh;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      const Pose one = random_pose(random, 0.3);
      Pose two = random_pose(random, 0.3);
      const std::string names = name_1 + " " + name_2;
      WarmStart warm;
      for (int frame = 0; frame < 4; ++frame) {
        const ObjectDistance r = solver.solve({*A1, one}, {*A2, two}, euclidean(), kWanted, &warm);
        const ObjectDistance cold = fresh.solve({*A1, one}, {*A2, two}, euclidean(), kWanted);
        if (cold.depth.evaluations == 0) break;  // apart
        expect_same(r.depth, cold.depth, names);
        EXPECT_EQ(r.distance.status, DistanceStatus::contains_origin) << names;
        if (frame > 0) {
          EXPECT_EQ(r.distance.counters.support_queries, 0) << names;
        }
        two = step(V(1, -2, 0.5), 0.01, V(0.002, 0.001, -0.001)).after(two);
      }
    }
  }
}

// Of polytopes the facet of before is nearly always the facet still: one look along it proves that.
TEST(WarmDepth, OfPolytopesTakesHalfTheSupportQueries) {
  Random random(62);
  ObjectDistanceSolver solver;
  const PreparedSet hull(sphere_points(3, 100, random));
  const Box box(V(-2, -2, -1), V(2, 2, 0));
  std::int64_t warm_queries = 0, cold_queries = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose one = random_pose(random, 0), two = random_pose(random, 0.8);
    WarmStart warm;
    solver.solve({box, one}, {hull, two}, euclidean(), kWanted, &warm);
    const Pose moved = step(V(1, 1, -1), 0.01, V(0.001, -0.001, 0.001)).after(two);
    const auto queries = [](const ObjectDistance& r) {
      return r.distance.counters.support_queries + r.depth.support_queries;
    };
    warm_queries += queries(solver.solve({box, one}, {hull, moved}, euclidean(), kWanted, &warm));
    cold_queries += queries(solver.solve({box, one}, {hull, moved}, euclidean(), kWanted));
  }
  EXPECT_LT(2 * warm_queries, cold_queries);
}

TEST(WarmDepth, OfBodiesThatHaveComeApartIsNone) {
  Random random(63);
  ObjectDistanceSolver solver;
  int searches = 0;  // where no formula has the depth
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      WarmStart warm;
      const Pose one = random_pose(random, 0), near = random_pose(random, 0.1), far = random_pose(random, 4);
      EXPECT_GT(solver.solve({*A1, one}, {*A2, near}, euclidean(), kWanted, &warm).depth.lower, 0);
      searches += warm.overlap ? 1 : 0;
      const ObjectDistance& apart = solver.solve({*A1, one}, {*A2, far}, euclidean(), kWanted, &warm);
      EXPECT_EQ(apart.distance.status, DistanceStatus::optimal) << name_1 << ' ' << name_2;
      EXPECT_EQ(apart.depth.evaluations, 0) << name_1 << ' ' << name_2;
      EXPECT_FALSE(warm.overlap) << name_1 << ' ' << name_2;
    }
  }
  EXPECT_GT(searches, 50);
}

// Bodies that part in small motions do so across the normal of before: one look along it, and no depth.
TEST(WarmDepth, OfBodiesThatPartAcrossTheNormalIsNotAskedFor) {
  Random random(66);
  ObjectDistanceSolver solver, fresh;
  int looks = 0;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      const std::string names = name_1 + " " + name_2;
      const Pose one = random_pose(random, 0.2), far = random_pose(random, 3);
      const DistanceResult start = fresh.solve({*A1, one}, {*A2, far}, euclidean()).distance;
      const auto at = [&](double gap) {
        return Pose(far.rotation(), far.translation() + start.normal * (start.distance - gap));
      };
      const Pose near = at(-1e-3), parted = at(1e-3);
      WarmStart warm;
      const ObjectDepth deep = solver.solve({*A1, one}, {*A2, near}, euclidean(), kWanted, &warm).depth;
      ASSERT_EQ(deep.evaluations, 1) << names;
      if (warm.overlap) {  // not where a formula has the depth
        BodyDepth bodies;
        ASSERT_TRUE(bodies.bind(*A1, *A2, InstructionSet::automatic)) << names;
        ASSERT_TRUE(bodies.place(PoseNumbers(&one), PoseNumbers(&parted))) << names;
        BodyDepthAnswer answer;
        bodies.solve(1e-6, {&warm, &warm.polytope}, Stopwatch(), answer);
        EXPECT_TRUE(answer.parted) << names;
        EXPECT_EQ(answer.iterations, 0) << names;
        ++looks;
      }
      const ObjectDistance r = solver.solve({*A1, one}, {*A2, parted}, euclidean(), kWanted, &warm);
      const ObjectDistance cold = fresh.solve({*A1, one}, {*A2, parted}, euclidean(), kWanted);
      EXPECT_EQ(r.distance.status, cold.distance.status) << names;
      EXPECT_LE(r.distance.lower, cold.distance.upper) << names;
      EXPECT_GE(r.distance.upper, cold.distance.lower) << names;
      EXPECT_EQ(r.depth.evaluations, 0) << names;
      EXPECT_EQ(r.depth.support_queries, 0) << names;
      EXPECT_FALSE(warm.overlap) << names;
    }
  }
  EXPECT_GT(looks, 50);
}

// The polytope of before is one of the bodies where they are now, and mostly all that a proof needs. What is
// kept of it does not grow with the number of solves.
TEST(WarmDepth, GoesOnFromThePolytopeOfBefore) {
  constexpr std::size_t kMostCorners = 127;
  Random random(67);
  ObjectDistanceSolver solver, fresh;
  std::int64_t warm_iterations = 0, cold_iterations = 0;
  std::size_t most = 0;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      const Pose one = random_pose(random, 0);
      Pose two = random_pose(random, 0.2);
      WarmStart warm;
      for (int frame = 0; frame < 40; ++frame) {
        const ObjectDepth r = solver.solve({*A1, one}, {*A2, two}, euclidean(), kWanted, &warm).depth;
        const ObjectDepth cold = fresh.solve({*A1, one}, {*A2, two}, euclidean(), kWanted).depth;
        if (cold.evaluations == 0) break;  // apart
        expect_same(r, cold, name_1 + " " + name_2);
        warm_iterations += frame > 0 ? r.iterations : 0;
        cold_iterations += frame > 0 ? cold.iterations : 0;
        most = std::max(most, warm.polytope.corners().size());
        two = step(V(1, -2, 0.5), 0.01, V(0.001, 0.001, -0.001)).after(two);
      }
    }
  }
  EXPECT_LT(2 * warm_iterations, cold_iterations);
  EXPECT_GT(most, 20);
  EXPECT_LE(most, kMostCorners);
}

// The rim of a cylinder rests on a box: its points are those that the box's faces see. The box is given by
// its corners: that of a Box needs no polytope, not even at first.
TEST(WarmDepth, OfACylinderThatTiltsOnABoxIsProvenByThePolytopeOfBefore) {
  const Box box(V(-2, -2, -1), V(2, 2, 0));
  Eigen::MatrixXd corners(3, 8);
  for (int i = 0; i < 8; ++i) corners.col(i) = V(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 0 : -1);
  const PointSet floor(corners);
  const Cylinder cylinder(V(0, 0, -0.5), V(0, 0, 0.5), 0.5);
  const Pose leaning = step(V(3, 2, 1), 0.7, V(0.1, 0.2, 0.68));
  ObjectDistanceSolver solver, fresh;
  for (const bool swapped : {false, true}) {
    WarmStart warm;
    Pose pose = leaning;
    const auto solve = [&]() -> const ObjectDepth& {
      const Posed one{floor}, two{cylinder, pose};
      return solver.solve(swapped ? two : one, swapped ? one : two, euclidean(), kWanted, &warm).depth;
    };
    EXPECT_GT(solve().iterations, 2);
    for (int frame = 0; frame < 5; ++frame) {
      pose = step(V(1, 2, 3), 0.01, V(0.001, 0.001, -0.001)).after(pose);
      const ObjectDepth& depth = solve();
      EXPECT_GT(depth.lower, 0);
      EXPECT_LE(depth.iterations, 1);
      const ObjectDepth direct = fresh.solve({box}, {cylinder, pose}, euclidean(), kWanted).depth;
      EXPECT_EQ(direct.iterations, 1);
      EXPECT_GE(direct.upper, depth.lower);
      EXPECT_LE(direct.lower, depth.upper);
    }
  }
}

// A warm start of other bodies, of another metric or of nonsense costs time only.
TEST(WarmDepth, FromAnyOtherPairIsProvenAllTheSame) {
  Random random(64);
  ObjectDistanceSolver solver, fresh;
  const Ball metric(Vector::Zero(3), 2.0);
  WarmStart warm;
  for (int i = 0; i < 3; ++i) {
    for (const auto& [name_1, A1] : depth_bodies()) {
      for (const auto& [name_2, A2] : depth_bodies()) {
        const Pose one = random_pose(random, 0.1), two = random_pose(random, 0.3);
        if (i == 1) warm.normal = {1e300, -1e-300, 5};
        if (i == 2) warm.point_A = warm.point_Q = {7, 7, 7, 7};
        const ObjectDistance& r = solver.solve({*A1, one}, {*A2, two}, metric, kWanted, &warm);
        const ObjectDistance& cold = fresh.solve({*A1, one}, {*A2, two}, metric, kWanted);
        if (cold.depth.evaluations > 0) expect_same(r.depth, cold.depth, name_1 + " " + name_2);
      }
    }
  }
}

// The same points, each within the root of the tolerance.
void expect_same(const ContactPatch& warm, const ContactPatch& cold, const std::string& names) {
  EXPECT_EQ(warm.count, cold.count) << names;
  EXPECT_LE(warm.lower, cold.upper) << names;
  EXPECT_GE(warm.upper, cold.lower) << names;
  for (const ContactPoint& p : warm.contacts()) {
    double least = INFINITY;
    for (const ContactPoint& q : cold.contacts()) least = std::min(least, length(p.point_1 - q.point_1));
    EXPECT_LT(least, kRootOfTolerance) << names;
  }
}

TEST(WarmDepth, GivesTheContactPatchThatAColdStartGives) {
  Random random(65);
  ContactPatchSolver solver, fresh;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      ObjectDistanceSolver distance;
      const Pose one = random_pose(random, 0.2), far = random_pose(random, 3);
      const DistanceResult apart = distance.solve({*A1, one}, {*A2, far}, euclidean()).distance;
      const std::string names = name_1 + " " + name_2;
      WarmStart warm;
      for (const double gap : {3e-4, 1e-4, -1e-4, -3e-4, -2e-4, 1e-4}) {
        const Pose two(far.rotation(), far.translation() + apart.normal * (apart.distance - gap));
        const ContactPatch& a = solver.solve({*A1, one}, {*A2, two}, 1e-3, &warm);
        const ContactPatch& b = fresh.solve({*A1, one}, {*A2, two}, 1e-3);
        expect_same(a, b, names + ' ' + std::to_string(gap));
      }
    }
  }
}

// One start for all: it comes from another pair, or from another pose of the same one.
TEST(WarmDepth, GivesThatContactPatchFromTheStartOfAnotherPairOrPose) {
  Random random(70);
  ObjectDistanceSolver distance;
  ContactPatchSolver solver, fresh;
  WarmStart warm;
  for (const double gap : {2e-4, -2e-4, 3e-5, -3e-5}) {
    for (const auto& [name_1, A1] : depth_bodies()) {
      for (const auto& [name_2, A2] : depth_bodies()) {
        const Pose one = random_pose(random, 0.2);
        Pose far = random_pose(random, 3);
        for (const double angle : {0.0, 0.1, 2.0}) {
          far = step(V(1, -2, 0.5), angle, V(0.1, 0.2, 0)).after(far);
          const DistanceResult apart = distance.solve({*A1, one}, {*A2, far}, euclidean()).distance;
          const Pose two(far.rotation(), far.translation() + apart.normal * (apart.distance - gap));
          expect_same(solver.solve({*A1, one}, {*A2, two}, 1e-3, &warm),
                      fresh.solve({*A1, one}, {*A2, two}, 1e-3),
                      name_1 + ' ' + name_2 + ' ' + std::to_string(gap));
        }
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_warm_depth
