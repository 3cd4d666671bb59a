// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_posed_queries {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;

Eigen::Vector3d random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

Pose random_pose(std::mt19937_64& random, double size) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return {q, random_vector(random, size)};
}

SetPointer random_hull(std::mt19937_64& random, int size) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(3, size);
  for (double& x : points.reshaped()) x = normal(random);
  points.colwise().normalize();
  return std::make_shared<PointSet>(points);
}

std::vector<SetPointer> bodies(std::mt19937_64& random) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d up(0, 0, 0.7);
  Eigen::Matrix3d factor = Eigen::Vector3d(1, 0.5, 0.3).asDiagonal();
  factor(0, 2) = 0.2;
  return {std::make_shared<Ball>(zero, 0.8),
          std::make_shared<Box>(Eigen::Vector3d(-0.5, -0.4, -0.6), Eigen::Vector3d(0.7, 0.4, 0.3)),
          std::make_shared<Capsule>(Eigen::Vector3d(-up), up, 0.3),
          std::make_shared<Cylinder>(Eigen::Vector3d(-up), up, 0.4),
          std::make_shared<TruncatedCone>(Eigen::Vector3d(-up), 0.6, up, 0.2),
          std::make_shared<Ellipsoid>(zero, factor),
          random_hull(random, 8),
          random_hull(random, 60)};
}

SetPointer moved(const SetPointer& S, const Pose& pose) {
  return AffineImage::rigid(S, pose.rotation(), pose.translation());
}

// Bounds of the same number, each certified: they overlap.
void expect_same(const DistanceResult& posed, const DistanceResult& copied) {
  EXPECT_EQ(posed.status, copied.status);
  EXPECT_LE(posed.lower, copied.upper);
  EXPECT_LE(copied.lower, posed.upper);
}

TEST(PosedQueries, GrowthDistanceIsThatOfTheMovedCopies) {
  std::mt19937_64 random(1);
  GrowthDistanceSolver solver, reference;
  const auto sets = bodies(random);
  for (const auto& A : sets) {
    for (const auto& Q : sets) {
      const Pose pose_A = random_pose(random, 3), pose_Q = random_pose(random, 0.1);
      expect_same(solver.solve({*A, pose_A}, {*Q, pose_Q}),
                  reference.solve(*moved(A, pose_A), *moved(Q, pose_Q)));
    }
  }
}

TEST(PosedQueries, EuclideanDistanceIsThatOfTheMovedCopies) {
  std::mt19937_64 random(2);
  const Ball unit(Eigen::Vector3d::Zero(), 1);
  ObjectDistanceSolver solver, reference;
  const auto sets = bodies(random);
  for (const auto& A1 : sets) {
    for (const auto& A2 : sets) {
      const Pose pose_1 = random_pose(random, 2), pose_2 = random_pose(random, 2);
      expect_same(solver.solve({*A1, pose_1}, {*A2, pose_2}, unit).distance,
                  reference.solve(*moved(A1, pose_1), *moved(A2, pose_2), unit).distance);
    }
  }
}

TEST(PosedQueries, GeneralizedDistanceIsThatOfTheMovedCopiesInSpacesOfAnyDimension) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int n = 2; n <= 6; ++n) {
    Eigen::MatrixXd M(n, n);
    for (double& x : M.reshaped()) x = normal(random);
    Eigen::MatrixXd R = Eigen::HouseholderQR<Eigen::MatrixXd>(M).householderQ();
    if (R.determinant() < 0) R.col(0) *= -1;
    const Pose pose_A(R, Vector::Constant(n, 2.5)), pose_Q(R.transpose(), Vector::Zero(n));
    const auto A = std::make_shared<Box>(Vector::Constant(n, -0.5), Vector::Constant(n, 0.25));
    const auto Q = std::make_shared<PNormBall>(Vector::Zero(n), Vector::LinSpaced(n, 1, 2), 3);
    for (const auto method :
         {DistanceMethod::column_generation, DistanceMethod::newton, DistanceMethod::zheng_yamane}) {
      DistanceOptions options;
      options.method = method;
      DistanceSolver solver(options), reference(options);
      expect_same(solver.solve({*A, pose_A}, {*Q, pose_Q}),
                  reference.solve(*moved(A, pose_A), *moved(Q, pose_Q)));
    }
  }
}

TEST(PosedQueries, NoWarmStartChangesWhatIsProven) {
  std::mt19937_64 random(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<WarmStart> corrupt(5);
  for (WarmStart& warm : corrupt) warm.dimension = 3;
  corrupt[0].normal = {nan, 0, 1};
  corrupt[1].normal = {0, 0, 0};
  corrupt[2].normal = {1e300, -1e300, 1e-300};
  corrupt[3].normal = {0, 1, 0};
  corrupt[3].count = 4;
  corrupt[3].point_A = {-1, 1 << 30, 7, 7};
  corrupt[3].point_Q = {1 << 30, -5, 0, 0};
  corrupt[4].dimension = 700;
  corrupt[4].count = -12;
  GrowthDistanceSolver solver, cold;
  const auto sets = bodies(random);
  WarmStart foreign;
  for (const auto& A : sets) {
    for (const auto& Q : sets) {
      const Pose pose_A = random_pose(random, 3), pose_Q = random_pose(random, 1);
      expect_same(solver.solve({*A, pose_A}, {*Q, pose_Q}, &foreign), cold.solve({*A, pose_A}, {*Q, pose_Q}));
      for (WarmStart warm : corrupt) {
        expect_same(solver.solve({*A, pose_A}, {*Q, pose_Q}, &warm), cold.solve({*A, pose_A}, {*Q, pose_Q}));
      }
    }
  }
}

TEST(PosedQueries, SeparationFollowsThePoses) {
  const Box box(Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1));
  const Pose turned(Eigen::Quaterniond(Eigen::AngleAxisd(std::acos(-1) / 4, Eigen::Vector3d::UnitZ())),
                    Eigen::Vector3d(2.3, 0, 0));
  const Pose straight(Eigen::Quaterniond::Identity(), Eigen::Vector3d(2.3, 0, 0));
  GrowthDistanceSolver solver;
  EXPECT_EQ(solver.separation({box, Pose(3)}, {box, straight}).outcome, Separation::separated);
  EXPECT_EQ(solver.separation({box, Pose(3)}, {box, turned}).outcome, Separation::intersecting);
}

TEST(PosedQueries, PosesOfAnotherSpaceAreRefused) {
  const Ball ball(Eigen::Vector3d::Zero(), 1), disc(Eigen::Vector2d::Zero(), 1);
  const Box box(Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1));
  const Pose plane(2), space(3);
  const std::vector<Posed> wrong = {{ball, plane}, {box, plane}, {disc, space}};
  for (const Posed& body : wrong) {
    const ConvexSet& metric = body.dimension() == 3 ? ball : disc;
    const Posed other(metric);
    for (const bool first : {true, false}) {
      const Posed &one = first ? body : other, &two = first ? other : body;
      EXPECT_THROW(DistanceSolver().solve(one, two, Effects::none), DimensionMismatchError);
      EXPECT_THROW(ObjectDistanceSolver().solve(one, two, metric, ObjectEffects::depth),
                   DimensionMismatchError);
      EXPECT_THROW(GrowthDistanceSolver().solve(one, two), DimensionMismatchError);
      EXPECT_THROW(GrowthDistanceSolver().separation(one, two), DimensionMismatchError);
      EXPECT_THROW(ContactPatchSolver().solve(one, two, 0.1), DimensionMismatchError);
      std::vector<Separation> outcome(1);
      SeparationAnswers answers;
      answers.outcome = outcome;
      const std::vector<PosedPair> pairs = {{one, two}};
      EXPECT_THROW(PairBatch(DistanceOptions()).separations(pairs, answers), DimensionMismatchError);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_posed_queries
