// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Bodies of revolution where u is the axis up to rounding: what is left of u across it is noise, and must not
// lead out of the set.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/sets/axis.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_axis {
namespace {

TEST(Axis, RadialPartIsOrthogonalHoweverNearUIsToTheAxis) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20000; ++trial) {
    const int n = 2 + trial % 6;
    const auto draw = [&] {
      return Vector(Vector::NullaryExpr(n, [&](Eigen::Index) { return normal(random); }));
    };
    const Vector p = draw();
    const Vector q = p + draw();
    const Axis axis("body", p, q);
    const Vector across = draw();
    const double share = trial % 3 == 0 ? 0.0 : std::ldexp(1.0, -(trial % 90));
    const Vector u =
        (trial % 2 == 0 ? 1 : -1) * axis.direction() * std::ldexp(1.0, trial % 7) + share * across;
    Vector radial(n);
    const double length = axis.radial_part(u.data(), radial.data());
    EXPECT_LE(std::fabs(radial.dot(axis.direction())), 8 * n * 0x1p-53) << "trial " << trial;
    if (length > 0) {
      EXPECT_NEAR(radial.norm(), 1.0, 1e-14);
    } else {
      EXPECT_EQ(radial, Vector::Zero(n));
    }
  }
}

// The disc of the base is met at its centre: 3 √3 away, less the radius of the ball.
TEST(Axis, ACuttingDiscIsFoundAtItsTrueDistance) {
  const double truth = 4.196152422706631880582;
  const Ball A1(Vector::Zero(3), 1), Q(Vector::Zero(3), 1);
  const TruncatedCone cone(Vector::Constant(3, 3), 1, Vector::Constant(3, 5), 0.5);
  const Cylinder cylinder(Vector::Constant(3, 3), Vector::Constant(3, 5), 1);
  for (const DistanceMethod method :
       {DistanceMethod::column_generation, DistanceMethod::newton, DistanceMethod::zheng_yamane}) {
    for (const ConvexSet* A2 :
         {static_cast<const ConvexSet*>(&cone), static_cast<const ConvexSet*>(&cylinder)}) {
      DistanceOptions options;
      options.method = method;
      ObjectDistanceSolver solver(options);
      const DistanceResult& result = solver.solve(A1, *A2, Q).distance;
      EXPECT_EQ(result.status, DistanceStatus::optimal) << to_string(method);
      EXPECT_LE(result.lower, truth * (1 + 2e-16)) << to_string(method);
      EXPECT_GE(result.upper, truth * (1 - 2e-16)) << to_string(method);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_axis
