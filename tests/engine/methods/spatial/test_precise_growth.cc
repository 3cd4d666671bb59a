// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_growth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "engine/queries/spatial_solve.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_precise_growth {
namespace {

using Eigen::Vector3d;
using testing::gaussian;
using testing::Random;
using testing::random_rotation;

constexpr double kThin = 1e-6;

Pose random_pose(Random& random) {
  const Eigen::Quaterniond rotation = random_rotation(random);
  return {rotation, gaussian(random)};
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

// Their difference is a plate a million times as wide as thick, of which a ball inside is known.
TEST(PreciseGrowth, TakesFewStepsOnBoxesAsLongAsNeedles) {
  Random random(8);
  GrowthDistanceSolver solver = make_solver();
  const Vector3d half_1(0.6, 0.5 * kThin, 0.4 * kThin), half_2(1, 0.3 * kThin, 0.7 * kThin);
  const Box one(-half_1, half_1), two(-half_2, half_2);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose pose_1 = random_pose(random), pose_2 = random_pose(random);
    const DistanceResult& r = solver.solve_about_centers({one, pose_1}, {two, pose_2});
    ASSERT_EQ(to_string(r.status), "optimal");
    EXPECT_LE(r.upper - r.lower, 1e-6 * r.upper);
    EXPECT_LE(r.counters.ray_iterations, 25) << "trial " << trial;
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
  const Capsule capsule_x(Vector3d(-1, 0, 0), Vector3d(1, 0, 0), kHalf);
  const Capsule capsule_y(Vector3d(0, -1, 0), Vector3d(0, 1, 0), kHalf);
  const double exact = 3 / (2 * kHalf);
  for (const auto& [one, two] : {std::pair<const ConvexSet*, const ConvexSet*>{&box_x, &box_y},
                                 {&smooth_x, &smooth_y},
                                 {&capsule_x, &capsule_y},
                                 {&box_x, &capsule_y}}) {
    const DistanceResult& r = solver.solve_about_centers(Posed(*one), {*two, pose});
    EXPECT_EQ(to_string(r.status), "optimal");
    EXPECT_LE(r.lower, exact);
    EXPECT_GE(r.upper, exact);
    EXPECT_LE(r.upper - r.lower, 1e-6 * r.upper);
  }
}

// Beside the general methods, which a limit on the iterations sends them to.
TEST(PreciseGrowth, CertifiesRoundNeedles) {
  Random random(2);
  std::uniform_real_distribution<double> uniform(0.2, 1);
  GrowthDistanceSolver solver = make_solver();
  DistanceOptions general;
  general.method = DistanceMethod::newton;
  general.max_iterations = 100000;
  GrowthDistanceSolver other(general);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::shared_ptr<const ConvexSet>> sets;
    for (int i = 0; i < 2; ++i) {
      const Vector3d end(uniform(random), 0, 0);
      const int kind = i == 0 ? trial % 3 : trial / 3 % 3;
      if (kind == 2) {
        const Vector3d half(end.x(), kThin * uniform(random), kThin * uniform(random));
        sets.push_back(std::make_shared<Ellipsoid>(Vector3d::Zero(), Eigen::MatrixXd(half.asDiagonal())));
      } else if (kind == 0) {
        sets.push_back(std::make_shared<Capsule>(Vector3d(-end), end, kThin * uniform(random)));
      } else {
        sets.push_back(std::make_shared<TruncatedCone>(Vector3d(-end), kThin * uniform(random), end,
                                                       kThin * uniform(random)));
      }
    }
    const Pose pose_1 = random_pose(random), pose_2 = random_pose(random);
    const DistanceResult& r = solver.solve_about_centers({*sets[0], pose_1}, {*sets[1], pose_2});
    EXPECT_EQ(to_string(r.status), "optimal") << trial;
    EXPECT_LE(r.upper - r.lower, 1e-6 * r.upper) << trial;
    const DistanceResult& s = other.solve_about_centers({*sets[0], pose_1}, {*sets[1], pose_2});
    EXPECT_LE(r.lower, s.upper) << trial;
    EXPECT_LE(s.lower, r.upper) << trial;
  }
}

// By fixed-size code itself: the general methods take a hundred times as long.
TEST(PreciseGrowth, CertifiesNeedlesOfEllipsoidsWithEveryKind) {
  Random random(5);
  const Vector3d half(1, kThin, 2 * kThin), end(1, 0, 0);
  Eigen::MatrixXd cloud = Eigen::MatrixXd::NullaryExpr(3, 30, [&]() { return gaussian(random).x(); });
  cloud.bottomRows(2) *= kThin;
  const Ellipsoid ellipsoid(Vector3d::Zero(), Eigen::MatrixXd(half.asDiagonal()));
  const Capsule capsule(Vector3d(-end), end, kThin);
  const TruncatedCone cone(Vector3d(-end), kThin, end, 2 * kThin);
  const Box box(Vector3d(-half), half);
  const PointSet points(cloud);
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.max_iterations = 100000;
  GrowthDistanceSolver general(options);
  const std::vector<const ConvexSet*> others = {&ellipsoid, &capsule, &cone, &box, &points};
  for (const ConvexSet* other : others) {
    for (int trial = 0; trial < 100; ++trial) {
      const Pose one = random_pose(random), two = random_pose(random);
      SpatialSolve solve;
      ASSERT_TRUE(solve.bind(ellipsoid, *other, InstructionSet::automatic));
      ASSERT_TRUE(solve.place(PoseNumbers(&one), PoseNumbers(&two)));
      ASSERT_TRUE(solve.growth(false, 1e-6, std::numeric_limits<double>::quiet_NaN(), nullptr)) << trial;
      const SpatialAnswer& answer = solve.answer();
      EXPECT_LE(answer.bounds.gap(), 1e-6 * answer.bounds.upper());
      const DistanceResult& r = general.solve_about_centers({*other, two}, {ellipsoid, one});
      EXPECT_LE(answer.bounds.lower(), r.upper);
      EXPECT_LE(r.lower, answer.bounds.upper());
    }
  }
}

// To the last bit: powers of two scale every rounding error, too.
TEST(PreciseGrowth, DoesNotDependOnTheScale) {
  Random random(4);
  GrowthDistanceSolver solver = make_solver();
  for (int trial = 0; trial < 20; ++trial) {
    const Pose pose_1 = random_pose(random), pose_2 = random_pose(random);
    DistanceResult results[2];
    for (int i = 0; i < 2; ++i) {
      const double scale = i == 0 ? 1 : 0x1p-80;
      const Vector3d end(scale, 0, 0);
      const Capsule one(Vector3d(-end), end, 0x1p-26 * scale);
      const TruncatedCone two(Vector3d(-end), 0x1p-26 * scale, end, 0x1p-27 * scale);
      const Pose at_1(pose_1.rotation(), Vector(scale * pose_1.translation()));
      const Pose at_2(pose_2.rotation(), Vector(scale * pose_2.translation()));
      results[i] = solver.solve_about_centers({one, at_1}, {two, at_2});
    }
    EXPECT_EQ(results[0].status, DistanceStatus::optimal);
    EXPECT_EQ(results[0].lower, results[1].lower);
    EXPECT_EQ(results[0].upper, results[1].upper);
  }
}

// Bodies with the same centre need not grow at all.
TEST(PreciseGrowth, IsZeroOfBodiesWithTheSameCenter) {
  Random random(3);
  GrowthDistanceSolver solver = make_solver();
  const Box box(Vector3d(-1, -2, -3), Vector3d(1, 2, 3));
  const Capsule capsule(Vector3d(-1, 0, 0), Vector3d(1, 0, 0), 0.5);
  const Capsule beside(Vector3d(1, 0, 0), Vector3d(3, 0, 0), 0.5);
  for (int trial = 0; trial < 20; ++trial) {
    const Pose one = random_pose(random), turned(random_pose(random).rotation(), one.translation());
    EXPECT_EQ(solver.solve_about_centers({box, one}, {capsule, turned}).status,
              DistanceStatus::contains_origin);
    EXPECT_EQ(solver.solve_about_centers({box, one}, {capsule, turned}).upper, 0);
    EXPECT_EQ(solver.separation({box, one}, {capsule, turned}).outcome, Separation::intersecting);
  }
  EXPECT_EQ(solver.solve_about_centers(Posed(beside), Posed(capsule)).status, DistanceStatus::optimal);
}

}  // namespace
}  // namespace raygauge::test_precise_growth
