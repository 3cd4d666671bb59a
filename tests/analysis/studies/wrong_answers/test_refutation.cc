// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/refutation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <vector>

#include "raygauge/sets/affine_image.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/cylinder.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/minkowski_difference.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_refutation {
namespace {

using Body = std::shared_ptr<const ConvexSet>;
using Eigen::Vector3d;

/// A body of each kind about the origin: it holds a ball of radius 0.2 and lies in one of radius 2.
std::vector<Body> bodies() {
  Eigen::Matrix3d factor;
  factor << 1, 0.5, 0, 0, 0.5, 0.25, 0, 0, 0.75;
  Eigen::MatrixXd corners(3, 6);
  corners << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3).toRotationMatrix();
  return {std::make_shared<Ball>(Vector3d::Zero(), 0.5),
          AffineImage::rigid(std::make_shared<Box>(Vector3d(-1, -0.5, -0.25), Vector3d(1, 0.5, 0.25)), turned,
                             Vector3d::Zero()),
          std::make_shared<Capsule>(Vector3d(-0.5, 0, 0.1), Vector3d(0.5, 0.2, 0), 0.3),
          std::make_shared<Cylinder>(Vector3d(-0.5, 0.2, 0), Vector3d(0.5, -0.1, 0), 0.4),
          std::make_shared<TruncatedCone>(Vector3d(0, 0, -0.5), 0.8, Vector3d(0, 0.2, 1), 0.1),
          std::make_shared<Ellipsoid>(Vector3d::Zero(), factor),
          std::make_shared<PointSet>(corners)};
}

Instance instance_of(const Body& A1, const Body& A2) {
  Instance instance;
  instance.A = std::make_shared<MinkowskiDifference>(A2, A1);
  instance.Q = std::make_shared<Ball>(Vector3d::Zero(), 1.0);
  return instance;
}

Body moved(const Body& S, const Vector3d& t) { return AffineImage::rigid(S, Eigen::Matrix3d::Identity(), t); }

TEST(BodyPieces, HaveTheSupportFunctionOfTheBody) {
  for (const Body& S : bodies()) {
    const auto pieces = pieces_of(*S);
    ASSERT_TRUE(pieces.has_value());
    for (const Vector3d& u : {Vector3d(1, 0, 0), Vector3d(-1, 2, 0.5), Vector3d(0.1, -0.3, -2)}) {
      Vector3d point;
      EXPECT_NEAR(pieces->support(u), S->support_unchecked(u.data(), point.data()), 1e-14);
    }
  }
}

TEST(BodyPieces, HoldThePointsOfTheBody) {
  for (const Body& S : bodies()) {
    const auto pieces = pieces_of(*S);
    for (const Vector3d& x : {Vector3d(0.1, 0, 0), Vector3d(-0.05, 0.1, 0.02), Vector3d(0, -0.1, -0.1)}) {
      const auto point = point_near(*S, x);
      ASSERT_TRUE(point.has_value());
      EXPECT_GE(point->weights.minCoeff(), 0);
      EXPECT_NEAR(point->weights.sum(), 1, 1e-12);
      EXPECT_LE(point->z.norm(), 1 + 1e-15);
      EXPECT_LE((point->in(*pieces) - x).norm(), 1e-14);
    }
  }
}

TEST(Refutation, OfAnAnswerTooSmallIsANormalAndOfOneTooLargeAreTwoPoints) {
  for (const Body& A1 : bodies()) {
    for (const Body& A2 : bodies()) {
      const Instance apart = instance_of(A1, moved(A2, Vector3d(4, 3, 0)));
      const auto small = refute(apart, 0, 1e-9);
      ASSERT_TRUE(small.has_value());
      EXPECT_TRUE(std::holds_alternative<SeparatingNormal>(small->proof));
      const auto large = refute(apart, small->distance + 1e-6, 1e-9);
      ASSERT_TRUE(large.has_value());
      ASSERT_TRUE(std::holds_alternative<ClosePoints>(large->proof));
      EXPECT_GE(large->distance, small->distance - 1e-12);
      EXPECT_FALSE(refute(apart, 0.5 * (small->distance + large->distance), 1e-6).has_value()) << "the truth";
    }
  }
}

TEST(Refutation, OfADistanceOfBodiesThatMeetIsACommonPoint) {
  for (const Body& A1 : bodies()) {
    for (const Body& A2 : bodies()) {
      for (const Vector3d& t : {Vector3d(0.2, 0.1, -0.1), Vector3d(0, 0, 0)}) {
        const auto found = refute(instance_of(A1, moved(A2, t)), 1e-8, 1e-9);
        ASSERT_TRUE(found.has_value());
        EXPECT_TRUE(std::holds_alternative<ClosePoints>(found->proof));
        EXPECT_LE(found->distance, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_refutation
