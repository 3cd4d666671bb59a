// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/counted_allocations.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/meshes/mesh_shapes.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_allocations {
namespace {

// The points behind the general interface.
class DisguisedPoints final : public ConvexSet {
 public:
  explicit DisguisedPoints(const PointSet& points) : ConvexSet(points.dimension()), points_(points) {}

 private:
  double do_support(const double* u, double* point) const override {
    return points_.support_unchecked(u, point);
  }
  void do_center(double* point) const override { points_.center_unchecked(point); }

  const PointSet& points_;
};

using Case = std::tuple<DistanceMethod, int, Effects>;

class RepeatedSolve : public ::testing::TestWithParam<Case> {
 protected:
  static long allocations_of_second_solve(const ConvexSet& A, const ConvexSet& Q) {
    DistanceOptions options;
    options.method = std::get<0>(GetParam());
    DistanceSolver solver(options);
    const Effects effects = std::get<2>(GetParam());
    EXPECT_EQ(solver.solve(A, Q, effects).status, DistanceStatus::optimal);
    const long before = allocations;
    solver.solve(A, Q, effects);
    return allocations - before;
  }
};

std::string name_of(const ::testing::TestParamInfo<Case>& instance) {
  const auto& [method, N, effects] = instance.param;
  return std::string(to_string(method)) + "_N" + std::to_string(N) +
         (has_effect(effects, Effects::witness) ? "_witness" : "");
}

// N = 200 is priced whole, N = 5000 through a sample.
INSTANTIATE_TEST_SUITE_P(Sizes, RepeatedSolve,
                         ::testing::Combine(::testing::Values(DistanceMethod::column_generation,
                                                              DistanceMethod::zheng_yamane,
                                                              DistanceMethod::newton),
                                            ::testing::Values(200, 5000),
                                            ::testing::Values(Effects::none, Effects::witness)),
                         name_of);

#if RAYGAUGE_COUNTS_ALLOCATIONS
TEST(AllocationCounter, SeesOperatorNewAndEigen) {
  const long before = allocations;
  const auto* number = new volatile double(1.0);
  delete number;
  const long after_new = allocations;
  EXPECT_GT(after_new, before);
  const Eigen::VectorXd vector = Eigen::VectorXd::Zero(100);
  EXPECT_GT(allocations, after_new);
  EXPECT_EQ(vector.size(), 100);
}
#endif

TEST_P(RepeatedSolve, OfPointSetsAllocatesNothing) {
  Random random(101);
  for (const int n : {2, 3, 5, 10, 20}) {
    const int N = std::get<1>(GetParam());
    Eigen::MatrixXd a = sphere_points(n, N, random);
    a.row(0).array() += 3;
    const PointSet A(a);
    const PointSet Q(sphere_points(n, N, random));
    EXPECT_EQ(allocations_of_second_solve(A, Q), 0) << "n = " << n;
  }
}

TEST_P(RepeatedSolve, OfGeneralSetsAllocatesNothing) {
  Random random(102);
  for (const int n : {2, 3, 5, 10, 20}) {
    const int N = std::get<1>(GetParam());
    Eigen::MatrixXd a = sphere_points(n, N, random);
    a.row(0).array() += 3;
    const PointSet A(a);
    const PointSet Q(sphere_points(n, N, random));
    EXPECT_EQ(allocations_of_second_solve(DisguisedPoints(A), DisguisedPoints(Q)), 0) << "n = " << n;
  }
}

TEST_P(RepeatedSolve, OfScaledSetsAllocatesNothing) {
  Random random(103);
  const int N = std::get<1>(GetParam());
  Eigen::MatrixXd a = sphere_points(4, N, random);
  a.row(0).array() += 3;
  const PointSet A(0x1p100 * a);
  const PointSet Q(0x1p80 * sphere_points(4, N, random));
  EXPECT_EQ(allocations_of_second_solve(A, Q), 0);
}

TEST_P(RepeatedSolve, OfNeedlesAllocatesNothing) {
  Random random(105);
  const int N = std::get<1>(GetParam());
  const Vector stretch = (Vector(5) << 1, 1e3, 1, 1, 30).finished();
  Eigen::MatrixXd a = sphere_points(5, N, random);
  a.row(0).array() += 3;
  const PointSet A(stretch.asDiagonal() * a);
  const PointSet Q(stretch.asDiagonal() * sphere_points(5, N, random));
  ASSERT_NE(Q.isotropic(), nullptr);
  EXPECT_EQ(allocations_of_second_solve(A, Q), 0);
}

TEST_P(RepeatedSolve, OfSmoothSetsAllocatesNothing) {
  Random random(104);
  for (const int n : {2, 3, 5, 10}) {
    const Vector away = 5 * Vector::Unit(n, 0);
    const Eigen::MatrixXd L = 0.2 * gaussian_points(n, n, random) + Eigen::MatrixXd::Identity(n, n);
    const Ellipsoid Q(Vector::Zero(n), L);
    EXPECT_EQ(allocations_of_second_solve(Ball(away, 1), Q), 0) << "n = " << n;
    const TruncatedCone cone(away, 1, away + Vector::Unit(n, 1), 0.5);
    EXPECT_EQ(allocations_of_second_solve(cone, Q), 0) << "n = " << n;
  }
}

TEST_P(RepeatedSolve, InQuadruplePrecisionAllocatesNothing) {
  for (const int n : {2, 3, 5}) {
    Eigen::MatrixXd L = Eigen::MatrixXd::Identity(n, n);
    L(0, 0) = 1e10;
    L(1, 0) = 3e10;
    const Ellipsoid Q(Vector::Zero(n), L);
    EXPECT_EQ(allocations_of_second_solve(Ellipsoid(9 * L.rowwise().sum(), L), Q), 0) << "n = " << n;
  }
}

TEST(RepeatedEuclideanDistance, AllocatesNothing) {
  Random random(107);
  for (const int n : {2, 3, 10, 40}) {
    for (const int N : {200, 5000}) {
      Eigen::MatrixXd a = sphere_points(n, N, random);
      a.row(0).array() += 3;
      const PointSet A(a);
      const Ball Q(Vector::Zero(n), 1);
      DistanceSolver solver;
      EXPECT_EQ(solver.solve(A, Q, Effects::witness).status, DistanceStatus::optimal);
      const long before = allocations;
      solver.solve(A, Q, Effects::witness);
      EXPECT_EQ(allocations - before, 0) << "n = " << n << ", N = " << N;
    }
  }
}

TEST(RepeatedObjectDistance, AllocatesNothing) {
  const Ball A1(Vector::Zero(3), 1), Q(Vector::Zero(3), 1);
  const TruncatedCone A2(Vector::Constant(3, 3), 1, Vector::Constant(3, 5), 0.5);
  for (const DistanceMethod method : {DistanceMethod::column_generation, DistanceMethod::newton}) {
    DistanceOptions options;
    options.method = method;
    ObjectDistanceSolver solver(options);
    constexpr ObjectEffects kAll = ObjectEffects::closest_points | ObjectEffects::gradient;
    EXPECT_EQ(solver.solve(A1, A2, Q, kAll).distance.status, DistanceStatus::optimal);
    const long before = allocations;
    solver.solve(A1, A2, Q, kAll);
    EXPECT_EQ(allocations - before, 0) << to_string(method);
  }
  GrowthDistanceSolver growth;
  growth.solve(A2, Q);
  growth.separation(A1, A2);
  const long before = allocations;
  growth.solve(A2, Q);
  growth.separation(A1, A2);
  EXPECT_EQ(allocations - before, 0);
}

// Bodies of R^3 in poses, cold and warm, by fixed-size code; the second of two frames is counted.
TEST(PosedSolve, AllocatesNothing) {
  Random random(106);
  const Vector zero = Vector::Zero(3);
  const PreparedSet hull(sphere_points(3, 200, random));
  const PointSet points(sphere_points(3, 50, random));
  const Ellipsoid ellipsoid(zero, Eigen::MatrixXd(Eigen::Vector3d(1, 0.5, 0.4).asDiagonal()));
  const TruncatedCone cone(-0.5 * Vector::Unit(3, 2), 0.6, 0.5 * Vector::Unit(3, 2), 0.3);
  const Ball metric(zero, 1);
  for (const ConvexSet* A :
       {static_cast<const ConvexSet*>(&hull), static_cast<const ConvexSet*>(&points),
        static_cast<const ConvexSet*>(&ellipsoid), static_cast<const ConvexSet*>(&cone)}) {
    ObjectDistanceSolver distance;
    GrowthDistanceSolver growth;
    WarmStart warm, warm_growth;
    long before = 0;
    for (int frame = 0; frame < 2; ++frame) {
      before = allocations;
      const Pose pose(Eigen::Quaterniond(1, 0.1 * frame, 0.2, 0.3), Eigen::Vector3d(3, 0.01 * frame, 0.2));
      const auto effects = ObjectEffects::closest_points | ObjectEffects::gradient;
      distance.solve({*A, pose}, {hull, Pose(3)}, metric, effects, &warm);
      growth.solve_about_centers({*A, pose}, {hull, Pose(3)}, &warm_growth);
      growth.separation({*A, pose}, {hull, Pose(3)}, &warm_growth);
    }
    EXPECT_EQ(allocations - before, 0);
  }
}

TEST(RepeatedDepth, AllocatesNothing) {
  Random random(13);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const PreparedSet hull(sphere_points(3, 200, random));
  const Ball ball(zero, 0.5), metric(zero, 1.0);
  const Ellipsoid ellipsoid(zero, Eigen::MatrixXd(Eigen::Vector3d(1, 0.5, 0.4).asDiagonal()));
  const TruncatedCone cone(Eigen::Vector3d(0, 0, -1), 0.5, Eigen::Vector3d(0, 0, 1), 0.25);
  const Pose pose(Eigen::Quaterniond(1, 0.1, 0.2, 0.3), Eigen::Vector3d(0.5, 0.2, 0.2));
  for (const ConvexSet* A :
       {static_cast<const ConvexSet*>(&hull), static_cast<const ConvexSet*>(&ball),
        static_cast<const ConvexSet*>(&ellipsoid), static_cast<const ConvexSet*>(&cone)}) {
    ObjectDistanceSolver solver;
    WarmStart warm;
    long before = 0;
    for (int repetition = 0; repetition < 3; ++repetition) {
      before = allocations;
      const auto effects = ObjectEffects::depth | ObjectEffects::gradient;
      const ObjectDistance& r = solver.solve({*A, pose}, {hull, Pose(3)}, metric, effects, &warm);
      EXPECT_EQ(r.depth.status, DistanceStatus::optimal);
    }
    EXPECT_EQ(allocations - before, 0);
  }
}

TEST(RepeatedGraspQuality, AllocatesNothing) {
  Random random(15);
  std::vector<GraspContact> contacts;
  const Eigen::MatrixXd points = sphere_points(3, 7, random);
  for (int i = 0; i < 7; ++i) contacts.push_back({points.col(i), -points.col(i), 0.5});
  const GraspWrenches W(contacts);
  const Ball metric(Vector::Zero(6), 1.0);
  DepthSolver solver;
  EXPECT_EQ(solver.solve(W, metric).status, DistanceStatus::optimal);
  const long before = allocations;
  EXPECT_GT(solver.solve(W, metric).lower, 0);
  EXPECT_EQ(allocations - before, 0);
}

// Gradients by pose and contact patches of bodies with faces, edges and curved surfaces.
TEST(RepeatedContact, AllocatesNothing) {
  Random random(14);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Box box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const PreparedSet hull(sphere_points(3, 200, random));
  const Ball ball(zero, 1), metric(zero, 1.0);
  const TruncatedCone cone(Eigen::Vector3d(0, 0, -1), 0.5, Eigen::Vector3d(0, 0, 1), 0.25);
  for (const ConvexSet* A : {static_cast<const ConvexSet*>(&box), static_cast<const ConvexSet*>(&hull),
                             static_cast<const ConvexSet*>(&ball), static_cast<const ConvexSet*>(&cone)}) {
    ObjectDistanceSolver distance;
    GrowthDistanceSolver growth;
    ContactPatchSolver patch;
    PoseGradient gradient;
    for (const double height : {2.001, 1.9}) {
      const Pose pose(Eigen::Quaterniond(1, 0, 0, 0.2), Eigen::Vector3d(0.1, 0.2, height));
      const auto effects = ObjectEffects::depth | ObjectEffects::pose_gradient;
      long before = 0;
      for (int repetition = 0; repetition < 3; ++repetition) {
        before = allocations;
        distance.solve({box}, {*A, pose}, metric, effects);
        growth.solve_about_centers({box}, {*A, pose}, nullptr, &gradient);
        patch.solve({box}, {*A, pose}, 0.05);
      }
      EXPECT_EQ(allocations - before, 0);
    }
  }
}

TEST(RepeatedHalfSpace, AllocatesNothing) {
  const HalfSpace floor(Eigen::Vector3d(0.1, 0.2, 1), 0.5);
  const TruncatedCone cone(Eigen::Vector3d(0, 0, -1), 0.5, Eigen::Vector3d(0, 0, 1), 0.25);
  const Ball metric(Eigen::Vector3d::Zero(), 1.0);
  const auto effects = ObjectEffects::closest_points | ObjectEffects::depth | ObjectEffects::gradient;
  for (const double height : {3.0, 0.5, 1.5 + 1e-9}) {
    const Pose pose(Eigen::Quaterniond(1, 0.1, 0.2, 0.3), Eigen::Vector3d(0, 0, height));
    ObjectDistanceSolver solver;
    GrowthDistanceSolver separation;
    long before = 0;
    for (int repetition = 0; repetition < 3; ++repetition) {
      before = allocations;
      solver.solve({cone, pose}, {floor, pose}, metric, effects);
      solver.solve({floor, pose}, {cone, pose}, metric, effects);
      separation.separation({cone, pose}, floor);
    }
    EXPECT_EQ(allocations - before, 0);
  }
}

// Of meshes apart, overlapping and against bodies; the workspace has grown before.
TEST(RepeatedMeshDistance, AllocatesNothing) {
  const testing::MeshShape torus = testing::torus_shape(2, 0.5, 60, 30);
  const Mesh mesh(torus.vertices, torus.triangles, MeshKind::solid);
  const Ball ball(Vector(Eigen::Vector3d(0.1, 0.2, 3)), 1);
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Pose apart(identity, Eigen::Vector3d(4, 1, 2)), across(identity, Eigen::Vector3d(1, 0, 0));
  MeshDistanceSolver solver;
  MeshWarmStart warm;
  constexpr ObjectEffects kAll = ObjectEffects::closest_points | ObjectEffects::gradient;
  for (const Pose* pose : {&apart, &across}) {
    solver.solve(mesh, {mesh, *pose}, kAll, &warm);
    long before = allocations;
    solver.solve(mesh, {mesh, *pose}, kAll, &warm);
    EXPECT_EQ(allocations - before, 0);
    before = allocations;
    EXPECT_NE(solver.separation(mesh, {mesh, *pose}), Separation::undecided);
    EXPECT_LE(allocations - before, 4);  // vectors of another length than before: normal, points, gradients
    solver.solve(mesh, {ball, *pose}, kAll);
    before = allocations;
    solver.solve(mesh, {ball, *pose}, kAll);
    EXPECT_EQ(allocations - before, 0);
  }
}

TEST(RepeatedMeshObject, AllocatesNothing) {
  const testing::MeshShape torus = testing::torus_shape(2, 0.5, 60, 30);
  const MeshObject object(Mesh(torus.vertices, torus.triangles, MeshKind::solid));
  const HalfSpace floor(Eigen::Vector3d(0.1, 0.2, 1), -4);
  const Ball metric(Eigen::Vector3d::Zero(), 2.0);
  constexpr ObjectEffects kAll = ObjectEffects::closest_points | ObjectEffects::gradient;
  ObjectDistanceSolver solver;
  WarmStart warm;
  for (int repetition = 0; repetition < 3; ++repetition) {
    const long before = allocations;
    solver.solve(floor, object, metric, kAll, &warm);
    EXPECT_TRUE(repetition == 0 || allocations == before);
  }
}

TEST(RepeatedSeparations, AllocateNothing) {
  const Box box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Ball ball(Vector(Eigen::Vector3d(0.1, 0.2, 3)), 1), far(Vector(Eigen::Vector3d(9, 0, 0)), 1);
  const TruncatedCone cone(Vector{{0, 0, 0}}, 1, Vector{{0, 0, 1}}, 0.5);
  std::vector<PosedPair> pairs;
  for (int i = 0; i < 50; ++i) {
    for (const ConvexSet* other : std::initializer_list<const ConvexSet*>{&box, &ball, &cone, &far})
      pairs.push_back({box, *other});
  }
  std::vector<Separation> outcome(pairs.size());
  PairBatch batch((DistanceOptions()));
  for (int repetition = 0; repetition < 3; ++repetition) {
    const long before = allocations;
    batch.separations(pairs, {outcome, {}});
    EXPECT_TRUE(repetition == 0 || allocations == before);
  }
}

}  // namespace
}  // namespace raygauge::test_solver_allocations
