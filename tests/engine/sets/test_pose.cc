// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/capability_queries.h"
#include "raygauge/sets/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "engine/sets/posed_view.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_pose {
namespace {

constexpr double kRounding = 1e-15;

TEST(Pose, TakesMatrixQuaternionAndIsometryForTheSameMotion) {
  const Eigen::Quaterniond q(0.4, -0.2, 0.8, 0.1);
  const Eigen::Vector3d t(1, -2, 3);
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = q.normalized().toRotationMatrix();
  isometry.translation() = t;
  const Eigen::Vector3d x(0.3, 0.5, -0.7);
  const Eigen::Vector3d image = isometry * x;
  for (const Pose& pose : {Pose(q, t), Pose(isometry), Pose(isometry.linear(), t)}) {
    EXPECT_LT((pose.apply(x) - image).norm(), 4 * kRounding);
    EXPECT_LT((pose.inverse().apply(image) - x).norm(), 8 * kRounding);
    EXPECT_LT((pose.after(pose).apply(x) - isometry * image).norm(), 8 * kRounding);
  }
}

TEST(Pose, IsAssignedInPlaceWithTheSameChecks) {
  const Pose given(Eigen::Quaterniond(0.4, -0.2, 0.8, 0.1), Eigen::Vector3d(1, -2, 3));
  Pose pose(3);
  pose.assign(given.rotation_data(), given.translation_data());
  EXPECT_EQ(pose.rotation(), given.rotation());
  EXPECT_EQ(pose.translation(), given.translation());
  EXPECT_EQ(pose.defect(), given.defect());
  EXPECT_FALSE(pose.is_axis_exchange());
  double R[9] = {1, 1e-5, 0, 0, 1, 0, 0, 0, 1}, t[3] = {0, 0, 0};
  EXPECT_THROW(pose.assign(R, t), InvalidParameterError);
  R[1] = 0;
  t[2] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(pose.assign(R, t), NonFiniteError);
}

TEST(Pose, IsAssignedAgainWithoutAChangeForAnyPoseThatWasChecked) {
  const Pose turned(Eigen::Quaterniond(0.4, -0.2, 0.8, 0.1), Eigen::Vector3d(1, -2, 3));
  Eigen::Isometry2d quarter = Eigen::Isometry2d::Identity();
  quarter.linear() << 0, -1, 1, 0;
  Eigen::MatrixXd swap = Eigen::MatrixXd::Identity(5, 5);
  swap.col(1).swap(swap.col(3));
  swap.col(0) *= -1;
  for (const Pose& given : {turned, Pose(quarter), Pose(swap, Eigen::VectorXd::Ones(5))}) {
    Pose pose(given.dimension());
    pose.assign_checked(given.rotation_data(), given.translation_data(), given.defect());
    EXPECT_EQ(pose.rotation(), given.rotation());
    EXPECT_EQ(pose.translation(), given.translation());
    EXPECT_EQ(pose.defect(), given.defect());
    EXPECT_EQ(pose.is_axis_exchange(), given.is_axis_exchange());
  }
}

TEST(Pose, TurnsThePlane) {
  Eigen::Isometry2d quarter = Eigen::Isometry2d::Identity();
  quarter.linear() << 0, -1, 1, 0;
  const Pose pose(quarter);
  EXPECT_TRUE(pose.is_axis_exchange());
  EXPECT_EQ(pose.defect(), 0);
  EXPECT_EQ(pose.apply(Eigen::Vector2d(2, 1)), Eigen::Vector2d(-1, 2));
}

// R rounded to `digits` digits after the point.
Eigen::Matrix3d printed(const Eigen::Matrix3d& R, int digits) {
  const double unit = std::pow(10.0, digits);
  return (R * unit).array().round() / unit;
}

TEST(Pose, TakesTheNearestRotationOfOneThatWasPrintedAndSaysHowFarItIs) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Matrix3d exact =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    const int digits = 6 + trial % 9;
    const Eigen::Matrix3d given = printed(exact, digits);
    const Pose pose(given, t);
    EXPECT_LE((pose.rotation() - exact).norm(), 1.6 * std::pow(10.0, -digits)) << digits;
    EXPECT_LE(pose.defect(), 3.1e-12);
    if (pose.replaced() == 0) {
      EXPECT_EQ(pose.rotation(), given);
    } else {
      EXPECT_LE(pose.defect(), 2e-14);
      EXPECT_NEAR(pose.replaced(), (pose.rotation() - given).cwiseAbs().maxCoeff(), 1e-15);
    }
    if (digits != 12) {
      EXPECT_EQ(pose.replaced() > 0, digits < 12) << digits;
    }
    EXPECT_EQ(nearest_rotation("R", given).R, pose.rotation());
    Pose again(3);
    again.assign(given.data(), t.data());
    EXPECT_EQ(again.rotation(), pose.rotation());
  }
}

TEST(Pose, SaysByHowMuchAMatrixIsNoRotation) {
  const Eigen::Vector3d t = Eigen::Vector3d::Zero();
  const auto said = [&](double scale) -> std::string {
    try {
      Pose(scale * Eigen::Matrix3d::Identity(), t);
    } catch (const InvalidParameterError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said(1 + 9e-7), "");
  EXPECT_NE(said(1 + 2e-6).find("by 2e-06"), std::string::npos) << said(1 + 2e-6);
  EXPECT_NE(said(2).find("by 3"), std::string::npos) << said(2);
}

TEST(Pose, RefusesWhatIsNoRigidMotion) {
  const Eigen::Vector3d t = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R(0, 1) = 1e-5;
  EXPECT_THROW(Pose(R, t), InvalidParameterError);
  EXPECT_THROW(Pose(Eigen::Matrix3d(-Eigen::Matrix3d::Identity()), t), InvalidParameterError);
  EXPECT_THROW(Pose(Eigen::Quaterniond(0, 0, 0, 0), t), InvalidParameterError);
  R(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Pose(R, t), NonFiniteError);
  EXPECT_THROW(Pose(Eigen::MatrixXd::Identity(2, 2), t), DimensionMismatchError);
  EXPECT_THROW(Pose{0}, InvalidParameterError);
  EXPECT_THROW(Pose(2).after(Pose(3)), DimensionMismatchError);
}

// The columns of the view's Hessian against differences of its support points.
TEST(PosedView, KeepsTheSecondOrderInformationOfASet) {
  const TruncatedCone cone(Eigen::Vector3d(0, 0, -1), 0.8, Eigen::Vector3d(0, 0, 1), 0.3);
  const Pose pose(Eigen::Quaterniond(0.4, -0.2, 0.8, 0.1), Eigen::Vector3d(1, -2, 3));
  const PosedView view(cone, pose);
  ASSERT_EQ(view.structure(), SupportStructure::smooth);
  const Eigen::Vector3d u(0.3, -0.6, 0.2);
  double points[3 * SupportPieces::kCapacity], hessians[9 * SupportPieces::kCapacity];
  SupportPieces pieces;
  pieces.dimension = 3;
  pieces.points = points;
  pieces.hessians = hessians;
  support_pieces(view, u.data(), pieces);
  ASSERT_EQ(pieces.count, 2);
  const int best = pieces.value[1] > pieces.value[0] ? 1 : 0;
  EXPECT_NEAR(pieces.value[static_cast<std::size_t>(best)], view.support_function(u), 8 * kRounding);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
    const Vector column = (view.support_mapping(u + step) - view.support_mapping(u - step)) / (2 * kStep);
    EXPECT_LT((column - Eigen::Vector3d::Map(pieces.hessian(best) + 3 * k)).norm(), 1e-8);
  }
}

}  // namespace
}  // namespace raygauge::test_pose
