// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/prepared_set.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>

#include "engine/sets/direction_table.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/exceptions.h"

namespace raygauge::test_prepared_set {
namespace {

using Random = std::mt19937_64;

Eigen::MatrixXd gaussian(int n, int N, Random& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(n, N);
  for (double& x : points.reshaped()) x = normal(random);
  return points;
}

struct Cloud {
  std::string name;
  Eigen::MatrixXd points;
};

Eigen::MatrixXd lattice(int side) {
  Eigen::MatrixXd points(3, side * side * side);
  for (int i = 0; i < points.cols(); ++i) points.col(i) << i % side, i / side % side, i / side / side;
  return points;
}

// Ties, duplicates, interior points, flat and needle-like sets, and few points.
std::vector<Cloud> clouds(Random& random) {
  std::vector<Cloud> out;
  for (const int N : {1, 3, 4, 8, 17, 60, 400}) {
    Eigen::MatrixXd sphere = gaussian(3, N, random);
    sphere.colwise().normalize();
    out.push_back({"sphere", sphere});
    out.push_back({"interior points", gaussian(3, N, random)});
    Eigen::MatrixXd twice(3, 2 * N);
    twice << sphere, sphere;
    out.push_back({"duplicates", twice});
    out.push_back({"flat", Eigen::Vector3d(1, 1, 0).asDiagonal() * sphere});
    out.push_back({"nearly flat", Eigen::Vector3d(1, 1, 1e-12).asDiagonal() * sphere});
    out.push_back({"needle", Eigen::Vector3d(1, 1e-6, 1e-6).asDiagonal() * sphere});
    out.push_back({"far away", sphere.colwise() + Eigen::Vector3d(1e6, -3e6, 2e6)});
    out.push_back({"large", 1e60 * sphere});
  }
  out.push_back({"lattice", lattice(6)});
  return out;
}

std::vector<Eigen::Vector3d> directions(Random& random) {
  std::vector<Eigen::Vector3d> out{Eigen::Vector3d::Zero(),   Eigen::Vector3d::UnitX(),
                                   -Eigen::Vector3d::UnitZ(), Eigen::Vector3d(1, 1, 0),
                                   Eigen::Vector3d(1, 1, 1),  Eigen::Vector3d(1e-9, 1, 0)};
  for (int i = 0; i < 200; ++i) out.emplace_back(gaussian(3, 1, random).col(0));
  return out;
}

TEST(PreparedSet, HasTheMaximumOverAllPoints) {
  Random random(11);
  for (const Cloud& cloud : clouds(random)) {
    const PreparedSet prepared(cloud.points);
    const Eigen::Vector3d magnitude = cloud.points.cwiseAbs().rowwise().maxCoeff();
    for (const Eigen::Vector3d& u : directions(random)) {
      const double highest = (u.transpose() * cloud.points).maxCoeff();
      const double rounding = 2 * ConvexSet::rounding_error(3) * u.cwiseAbs().dot(magnitude);
      EXPECT_NEAR(prepared.support_function(u), highest, rounding) << cloud.name;
      EXPECT_NEAR(u.dot(prepared.support_mapping(u)), highest, rounding) << cloud.name;
    }
  }
}

// What fixed-size code asks: the highest of the points listed for a cell is the highest of all.
TEST(PreparedSet, ListsTheHighestPointOfEveryDirection) {
  Random random(12);
  for (const Cloud& cloud : clouds(random)) {
    const PreparedSet prepared(cloud.points);
    const SpatialShape& shape = *prepared.spatial_shape();
    ASSERT_NE(shape.table, nullptr);
    const Eigen::Vector3d magnitude = cloud.points.cwiseAbs().rowwise().maxCoeff();
    for (const Eigen::Vector3d& u : directions(random)) {
      const std::int32_t listed = shape.table->highest({u.x(), u.y(), u.z()});
      if (listed < 0) continue;  // a long list is not kept
      const double highest = (u.transpose() * cloud.points).maxCoeff();
      const double rounding = 2 * ConvexSet::rounding_error(3) * u.cwiseAbs().dot(magnitude);
      EXPECT_GE(u.dot(prepared.points().point(listed)), highest - rounding) << cloud.name;
    }
  }
}

// Of points on a sphere few are listed, so that no direction needs a pass over all points.
TEST(PreparedSet, ListsFewPointsOfASphere) {
  Random random(15);
  for (const int N : {8, 200, 2000}) {
    const PreparedSet prepared(gaussian(3, N, random).colwise().normalized());
    const SpatialShape& shape = *prepared.spatial_shape();
    for (const Eigen::Vector3d& u : directions(random))
      EXPECT_GE(shape.table->highest({u.x(), u.y(), u.z()}), 0);
    EXPECT_LT(prepared.memory(), 30000 + 200 * N);
  }
}

// Nor of long or flat ones, also in directions across them, along which only the thin axes tell points apart.
TEST(PreparedSet, ListsFewPointsOfANeedle) {
  Random random(17);
  for (const double thin : {1e-2, 1e-6}) {
    for (const Eigen::Vector3d& axes : {Eigen::Vector3d(1, thin, thin), Eigen::Vector3d(1, 1, thin)}) {
      const Eigen::Matrix3d rotation = Eigen::Quaterniond(1, 2, 3, 4).normalized().toRotationMatrix();
      const Eigen::Matrix3d across = rotation * axes.cwiseInverse().asDiagonal();
      const Eigen::MatrixXd points =
          rotation * axes.asDiagonal() * gaussian(3, 2000, random).colwise().normalized();
      const PreparedSet prepared(points);
      const SpatialShape& shape = *prepared.spatial_shape();
      for (const Eigen::Vector3d& w : directions(random)) {
        for (const Eigen::Vector3d& u : {w, Eigen::Vector3d(across * w)}) {
          const std::int32_t listed = shape.table->highest({u.x(), u.y(), u.z()});
          ASSERT_GE(listed, 0) << axes.transpose() << ", u = " << u.transpose();
          EXPECT_GE(u.dot(prepared.points().point(listed)),
                    (u.transpose() * points).maxCoeff() - ConvexSet::rounding_error(3) * u.norm());
        }
      }
    }
  }
}

// A direction on the border of two cells, to rounding, is at home in both.
TEST(DirectionTable, ListsTheHighestPointOnTheBordersOfCells) {
  Random random(16);
  const Eigen::Matrix3Xd points = gaussian(3, 200, random).colwise().normalized();
  const DirectionTable table(points);
  for (int i = -16; i <= 16; ++i) {
    for (const double near : {-1e-16, 0.0, 1e-16}) {
      for (const Eigen::Vector3d& u :
           {Eigen::Vector3d(1, i / 16.0 + near, 0.3), Eigen::Vector3d(i / 8.0 + near, -1, 1),
            Eigen::Vector3d(-1 + near, i / 16.0, 1)}) {
        const std::int32_t listed = table.highest({u.x(), u.y(), u.z()});
        ASSERT_GE(listed, 0);
        EXPECT_NEAR(u.dot(points.col(listed)), (u.transpose() * points).maxCoeff(), 1e-15);
      }
    }
  }
}

TEST(PreparedSet, DropsPointsDeepInsideAndKeepsTheCentre) {
  Random random(13);
  Eigen::MatrixXd points(3, 300);
  points << gaussian(3, 100, random).colwise().normalized(),
      0.3 * gaussian(3, 200, random).colwise().normalized();
  const PreparedSet prepared(points);
  EXPECT_EQ(prepared.points().size(), PreparedSet::has_hulls() ? 100 : 300);
  EXPECT_LT((prepared.center() - PointSet(points).center()).norm(), 1e-15);
  EXPECT_GT(prepared.memory(), 0);
}

// The cube {|x_k| <= 1}: its inner radius is 1, and no ball about its centre that is claimed may be larger.
TEST(PreparedSet, KnowsABallInsideThatIsInside) {
  const Eigen::MatrixXd cube = lattice(3).array() - 1;
  const PreparedSet prepared(cube);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const double radius = prepared.inner_radius_unchecked(zero.data());
  EXPECT_LE(radius, 1);
  EXPECT_GE(radius, PreparedSet::has_hulls() ? 1 - 1e-7 : 0.0);
}

TEST(PreparedSet, OfFewPointsInOtherDimensionsIsThePointsThemselves) {
  Random random(14);
  for (const int n : {1, 2, 5}) {
    const Eigen::MatrixXd points = gaussian(n, 50, random);
    const PreparedSet prepared(points);
    const Vector u = gaussian(n, 1, random).col(0);
    EXPECT_EQ(prepared.support_function(u), PointSet(points).support_function(u));
    EXPECT_EQ(prepared.points().points(), points);
    EXPECT_EQ(prepared.vertex_count(), 0);
  }
}

TEST(PreparedSet, RefusesWhatAPointSetRefuses) {
  EXPECT_THROW(PreparedSet(Eigen::MatrixXd(3, 0)), EmptySetError);
  EXPECT_THROW(PreparedSet(Eigen::MatrixXd::Constant(3, 4, std::nan(""))), NonFiniteError);
}

}  // namespace
}  // namespace raygauge::test_prepared_set
