// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_spatial_solve {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

std::vector<std::shared_ptr<const ConvexSet>> bodies() {
  const Eigen::Vector3d up(0, 0, 0.6);
  const Eigen::Matrix3d axes = Eigen::Vector3d(1, 0.6, 0.4).asDiagonal();
  return {std::make_shared<Ball>(Eigen::Vector3d(0.1, 0, 0), 0.8),
          std::make_shared<Box>(Eigen::Vector3d(-0.6, -0.5, -0.4), Eigen::Vector3d(0.6, 0.5, 0.4)),
          std::make_shared<Capsule>(Eigen::Vector3d(-up), up, 0.4),
          std::make_shared<Cylinder>(Eigen::Vector3d(-up), up, 0.5),
          std::make_shared<Ellipsoid>(Eigen::Vector3d(0, 0, 0), axes),
          std::make_shared<PreparedSet>(Eigen::MatrixXd(Eigen::MatrixXd::Random(3, 60)))};
}

// Where a body is at step k: it passes another one at the origin, turning, and flies through it on the way.
Pose flight(int k) {
  const double time = 0.05 * k;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 0.5).normalized();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(time, axis)), Eigen::Vector3d(2.5 - time, 0.3, 0.2)};
}

TEST(SpatialSolve, AnswersAsOneBoundAnewDoesWhereverTheBodiesAreMoved) {
  const auto sets = bodies();
  for (const auto& first : sets) {
    for (const auto& second : sets) {
      SpatialSolve kept;
      ASSERT_TRUE(kept.bind(*first, *second, InstructionSet::automatic));
      for (int k = 0; k < 100; ++k) {
        const Pose one(3), two = flight(k);
        SpatialSolve fresh;
        ASSERT_TRUE(fresh.bind(*first, *second, InstructionSet::automatic));
        ASSERT_TRUE(fresh.place(PoseNumbers(&one), PoseNumbers(&two)) &&
                    kept.place(PoseNumbers(&one), PoseNumbers(&two)));
        const bool found = kept.distance(1e-6, nullptr);
        ASSERT_EQ(fresh.distance(1e-6, nullptr), found);
        if (!found) continue;
        EXPECT_EQ(kept.answer().end, fresh.answer().end);
        EXPECT_EQ(kept.answer().bounds.lower(), fresh.answer().bounds.lower());
        EXPECT_EQ(kept.answer().bounds.upper(), fresh.answer().bounds.upper());
        ASSERT_EQ(kept.growth(false, 1e-6, kNever, nullptr), fresh.growth(false, 1e-6, kNever, nullptr));
        EXPECT_EQ(kept.answer().bounds.lower(), fresh.answer().bounds.lower());
        EXPECT_EQ(kept.answer().bounds.upper(), fresh.answer().bounds.upper());
      }
    }
  }
}

TEST(SpatialSolve, ForgetsAboutTheOriginWhenTheBodiesAreMoved) {
  const Box box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Pose here(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.5, 0, 0));
  const Pose there(Eigen::Quaterniond::Identity(), Eigen::Vector3d(4, 0, 0));
  SpatialSolve solve;
  ASSERT_TRUE(solve.bind(box, box, InstructionSet::automatic) &&
              solve.place(PoseNumbers(&here), PoseNumbers(&there)));
  ASSERT_TRUE(solve.growth(true, 1e-9, kNever, nullptr));  // 1.5 σ = 4 - σ
  EXPECT_NEAR(solve.answer().bounds.upper(), 1.6, 1e-8);
  ASSERT_TRUE(solve.place(PoseNumbers(&here), PoseNumbers(&there)) &&
              solve.growth(false, 1e-9, kNever, nullptr));
  EXPECT_NEAR(solve.answer().bounds.upper(), 1.75, 1e-8);  // 0.5 + σ = 4 - σ
}

TEST(SpatialSolve, ProvesItsBoundsFromAnyStart) {
  const auto sets = bodies();
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int32_t> index(-5, 70);
  for (const auto& first : sets) {
    for (const auto& second : sets) {
      SpatialSolve solve;
      const Pose one(3), two = flight(3);
      ASSERT_TRUE(solve.bind(*first, *second, InstructionSet::automatic) &&
                  solve.place(PoseNumbers(&one), PoseNumbers(&two)));
      ASSERT_TRUE(solve.distance(1e-9, nullptr));
      const double lower = solve.answer().bounds.lower(), upper = solve.answer().bounds.upper();
      for (int trial = 0; trial < 100; ++trial) {
        WarmStart corrupt;
        corrupt.dimension = 3;
        corrupt.count = index(random);
        for (auto* points : {&corrupt.point_A, &corrupt.point_Q}) {
          for (std::int32_t& point : *points) point = index(random);
        }
        corrupt.normal = {std::ldexp(1.0, 40 * index(random)), trial % 3 == 0 ? std::nan("") : 1.0, -1};
        if (!solve.distance(1e-9, &corrupt)) continue;
        EXPECT_LE(solve.answer().bounds.lower(), upper);
        EXPECT_GE(solve.answer().bounds.upper(), lower);
      }
    }
  }
}

TEST(SpatialSolve, IsLeftToOthersForBodiesOfOtherSpaces) {
  const Ball plane(Eigen::Vector2d(0, 0), 1), space(Eigen::Vector3d(0, 0, 0), 1);
  const Ball four(Eigen::VectorXd::Zero(4), 1);
  SpatialSolve solve;
  EXPECT_FALSE(solve.bind(plane, space, InstructionSet::automatic));
  EXPECT_FALSE(solve.bind(four, four, InstructionSet::automatic));
  EXPECT_TRUE(solve.bind(plane, plane, InstructionSet::automatic));
}

}  // namespace
}  // namespace raygauge::test_spatial_solve
