// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/refutation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
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

Instance asked(Quantity quantity, const Body& A1, const Body& A2) {
  Instance instance = instance_of(A1, A2);
  instance.quantity = quantity;
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
      const auto large = refute(apart, small->proven + 1e-6, 1e-9);
      ASSERT_TRUE(large.has_value());
      ASSERT_TRUE(std::holds_alternative<ClosePoints>(large->proof));
      EXPECT_GE(large->proven, small->proven - 1e-12);
      EXPECT_FALSE(refute(apart, 0.5 * (small->proven + large->proven), 1e-6).has_value()) << "the truth";
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
        EXPECT_LE(found->proven, 1e-12);
      }
    }
  }
}

TEST(Refutation, OfADepthTooSmallIsASurfaceAndOfOneTooLargeIsANormal) {
  ObjectDistanceSolver solver;
  const Ball unit(Vector3d::Zero(), 1.0);
  int without = 0;
  for (const Body& A1 : bodies()) {
    for (const Body& A2 : bodies()) {
      const Body near = moved(A2, Vector3d(0.2, 0.1, -0.1));
      const ObjectDepth depth = solver.solve(*A1, *near, unit, ObjectEffects::depth).depth;
      const Instance instance = asked(Quantity::depth, A1, near);
      if (const auto small = refute(instance, 0.9 * depth.lower, 1e-9); small.has_value()) {
        const auto& surface = std::get<SurfaceAround>(small->proof);
        EXPECT_EQ(surface.triangles.size(), 2 * surface.corners.size() - 4) << "Euler's formula";
      } else {
        ++without;
      }
      const auto large = refute(instance, depth.upper + 1e-6, 1e-9);
      ASSERT_TRUE(large.has_value());
      EXPECT_TRUE(std::holds_alternative<SeparatingNormal>(large->proof));
      EXPECT_LE(large->proven, depth.upper + 1e-9);
      EXPECT_FALSE(refute(instance, depth.depth, 1e-6).has_value()) << "the truth";
    }
  }
  EXPECT_LE(without, 1) << "but for two octahedra, of whose difference many facets are in one plane";
}

TEST(Refutation, OfAGrowthDistanceIsANormalOrAPointOfBothGrownBodies) {
  GrowthDistanceSolver solver;
  for (const Body& A1 : bodies()) {
    for (const Body& A2 : bodies()) {
      for (const Vector3d& t : {Vector3d(0.2, 0.1, -0.1), Vector3d(4, 3, 0)}) {
        const DistanceResult growth = solver.solve_about_centers(*A1, *moved(A2, t));
        const Instance instance = asked(Quantity::growth, A1, moved(A2, t));
        const auto small = refute(instance, growth.lower - 1e-5, 1e-9);
        ASSERT_TRUE(small.has_value());
        EXPECT_TRUE(std::holds_alternative<SeparatingNormal>(small->proof));
        const auto large = refute(instance, growth.upper + 1e-5, 1e-9);
        ASSERT_TRUE(large.has_value());
        EXPECT_TRUE(std::holds_alternative<ClosePoints>(large->proof));
        EXPECT_FALSE(refute(instance, growth.distance, 1e-5).has_value()) << "the truth";
      }
    }
  }
}

// Bodies a thousand times as long as they are thick that overlap by a tenth of what they are said to be
// apart.
TEST(Refutation, OfNeedlesThatHardlyOverlap) {
  std::mt19937_64 random(51);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Vector3d(normal(random), normal(random), normal(random)).normalized();
  };
  const auto needle = std::make_shared<Box>(Vector3d(-0.5, -5e-4, -5e-4), Vector3d(0.5, 5e-4, 5e-4));
  const auto rod = std::make_shared<Capsule>(Vector3d(-0.5, 0, 0), Vector3d(0.5, 0, 0), 5e-4);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(i, direction()).toRotationMatrix();
    const Body A1 = AffineImage::rigid(needle, turned, Vector3d::Zero());
    const Vector3d u = direction();
    Vector3d at_1, at_2;
    A1->support_unchecked(u.data(), at_1.data());
    const Vector3d back = -u;
    rod->support_unchecked(back.data(), at_2.data());
    const Body A2 = moved(rod, at_1 - at_2 - 4e-9 * u);
    EXPECT_TRUE(refute(instance_of(A1, A2), 4e-8, 1e-9).has_value()) << i;
  }
}

TEST(Refutation, OfASeparationIsACommonPointOrANormal) {
  for (const Body& A1 : bodies()) {
    for (const Body& A2 : bodies()) {
      const auto apart = asked(Quantity::separated, A1, moved(A2, Vector3d(4, 3, 0)));
      EXPECT_FALSE(refute(apart, 1, 1e-9).has_value()) << "the truth";
      ASSERT_TRUE(refute(apart, 0, 1e-9).has_value());
      const auto meet = asked(Quantity::separated, A1, moved(A2, Vector3d(0.2, 0.1, -0.1)));
      EXPECT_FALSE(refute(meet, 0, 1e-9).has_value()) << "the truth";
      ASSERT_TRUE(refute(meet, 1, 1e-9).has_value());
    }
  }
}

}  // namespace
}  // namespace raygauge::test_refutation
