// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_growth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::test_precise_growth {
namespace {

using Eigen::Vector3d;
using Random = std::mt19937_64;

constexpr double kThin = 1e-6;

Vector3d gaussian(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

Pose random_pose(Random& random) {
  const Vector3d v = gaussian(random);
  return {Eigen::Quaterniond(gaussian(random).x(), v.x(), v.y(), v.z()).normalized(), gaussian(random)};
}

GrowthDistanceSolver make_solver() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return GrowthDistanceSolver(options);
}

// u·p/h_B(u) for the normal of the result, in long doubles: a lower bound whatever the normal is.
long double bound_of(const DistanceResult& r, const PointSet& one, const Pose& pose_1, const PointSet& two,
                     const Pose& pose_2, const Eigen::MatrixXd* points) {
  using Wide = Eigen::Matrix<long double, 3, Eigen::Dynamic>;
  const Wide u = -r.normal.cast<long double>();
  const Wide R_1 = pose_1.rotation().cast<long double>(), R_2 = pose_2.rotation().cast<long double>();
  const Wide c_1 = R_1 * one.center().cast<long double>(), c_2 = R_2 * two.center().cast<long double>();
  const Wide p =
      c_2 - c_1 + pose_2.translation().cast<long double>() - pose_1.translation().cast<long double>();
  const long double top =
      (u.transpose() * R_1 * points[0].cast<long double>()).maxCoeff() - (u.transpose() * c_1).value();
  const long double bottom =
      (u.transpose() * R_2 * points[1].cast<long double>()).minCoeff() - (u.transpose() * c_2).value();
  return (u.transpose() * p).value() / (top - bottom);
}

TEST(PreciseGrowth, CertifiesNeedlesOfPoints) {
  Random random(1);
  GrowthDistanceSolver solver = make_solver();
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::MatrixXd points[2] = {Eigen::MatrixXd(3, 8), Eigen::MatrixXd(3, 8)};
    for (Eigen::MatrixXd& each : points) {
      for (int i = 0; i < 8; ++i) each.col(i) = gaussian(random).normalized();
      each.bottomRows(2) *= kThin;
    }
    const PointSet one(points[0]), two(points[1]);
    const Pose pose_1 = random_pose(random), pose_2 = random_pose(random);
    const DistanceResult& r = solver.solve_about_centers({one, pose_1}, {two, pose_2});
    ASSERT_EQ(to_string(r.status), "optimal");
    EXPECT_LE(r.upper - r.lower, 1e-6 * r.upper);
    const auto bound = static_cast<double>(bound_of(r, one, pose_1, two, pose_2, points));
    EXPECT_GE(bound, r.lower * (1 - 1e-9));  // the normal is rounded to doubles
    EXPECT_LE(bound, r.upper * (1 + 1e-9));
  }
}

// Crossed needles: σ = distance / (half thickness of both), along z.
TEST(PreciseGrowth, HoldsTheValueOfCrossedNeedlesThatIsKnownExactly) {
  GrowthDistanceSolver solver = make_solver();
  constexpr double kHalf = 0x1p-20;
  const Box box_x(Vector3d(-1, -kHalf, -kHalf), Vector3d(1, kHalf, kHalf));
  const Box box_y(Vector3d(-kHalf, -1, -kHalf), Vector3d(kHalf, 1, kHalf));
  const Ellipsoid smooth_x(Vector3d::Zero(), Eigen::MatrixXd(Vector3d(1, kHalf, kHalf).asDiagonal()));
  const Ellipsoid smooth_y(Vector3d::Zero(), Eigen::MatrixXd(Vector3d(kHalf, 1, kHalf).asDiagonal()));
  const Pose pose(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Vector3d(0, 0, 3));
  const double exact = 3 / (2 * kHalf);
  for (const auto& [one, two] :
       {std::pair<const ConvexSet*, const ConvexSet*>{&box_x, &box_y}, {&smooth_x, &smooth_y}}) {
    const DistanceResult& r = solver.solve_about_centers(Posed(*one), {*two, pose});
    EXPECT_EQ(to_string(r.status), "optimal");
    EXPECT_LE(r.lower, exact);
    EXPECT_GE(r.upper, exact);
    EXPECT_LE(r.upper - r.lower, 1e-6 * r.upper);
  }
}

}  // namespace
}  // namespace raygauge::test_precise_growth
