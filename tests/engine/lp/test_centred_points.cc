// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/centred_points.h"

#include <gtest/gtest.h>

#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_centred_points {
namespace {

bool centred(const Eigen::MatrixXd& points, InstructionSet isa = InstructionSet::automatic) {
  const PointSet S(points);
  const PricedPoints view = {S.data(), S.block_count(), nullptr, 0, S.size()};
  return are_centred(view, S.dimension(), kernels_for(isa), Stopwatch());
}

TEST(CentredPoints, SurroundTheOriginOnEveryInstructionSet) {
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const int n : {1, 2, 7, 40, 100}) {
      Random random(static_cast<unsigned>(n));
      const Eigen::MatrixXd points = sphere_points(n, 20 * n, random);
      EXPECT_TRUE(centred(points.leftCols(5 * n), isa) || n < 7) << n;
      for (const double size : {1e-100, 1e-3, 1.0, 1e80}) EXPECT_TRUE(centred(size * points, isa)) << n;
      Eigen::MatrixXd flat = points;
      flat.row(0) *= 1e-3;
      EXPECT_TRUE(centred(flat, isa)) << n;
    }
  }
}

// In each of them the origin is outside or on the boundary.
TEST(CentredPoints, AreNoneThatADirectionLeavesBehind) {
  for (const int n : {2, 7, 40}) {
    Random random(static_cast<unsigned>(n));
    Eigen::MatrixXd points = sphere_points(n, 20 * n, random);
    points.row(0) = points.row(0).cwiseAbs();
    EXPECT_FALSE(centred(points)) << "half a ball, n = " << n;
    points.row(0).leftCols(15 * n).setZero();
    EXPECT_FALSE(centred(points)) << "on a face, n = " << n;
    points.row(0) *= 1e-13;
    EXPECT_FALSE(centred(points)) << "but for rounding, n = " << n;
    points.row(0).setZero();
    EXPECT_FALSE(centred(points)) << "flat, n = " << n;
    EXPECT_FALSE(centred(points.leftCols(n)));
    EXPECT_FALSE(centred(1e-200 * sphere_points(n, 20 * n, random))) << "squares underflow";
    EXPECT_FALSE(centred(1e200 * sphere_points(n, 20 * n, random))) << "squares overflow";
  }
}

// Integers whose last coordinate is the sum of the others, each with its mirror image: the sum of all is
// zero, and their matrix is singular, though rounding may not show it.
TEST(CentredPoints, AreNoneInAPlane) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const int n = 3 + static_cast<int>(seed % 20);
    Random random(seed);
    Eigen::MatrixXd half = (1000 * gaussian_points(n, 10 * n, random)).array().round();
    half.row(n - 1) = half.topRows(n - 1).colwise().sum();
    Eigen::MatrixXd points(n, 20 * n);
    points << half, -half;
    EXPECT_FALSE(centred(points)) << "seed " << seed;
    points(n - 1, 0) += 1000;  // out of it, and its mirror image to the other side
    points(n - 1, 10 * n) -= 1000;
    EXPECT_TRUE(centred(points)) << "seed " << seed;
  }
}

// The margin by which points lie on one side of the origin, relative to their size, down to nothing.
TEST(CentredPoints, AreNotProvenByRounding) {
  const int n = 5;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Eigen::MatrixXd points = sphere_points(n, 200, random);
    for (double margin = 1; margin > 1e-18; margin *= 0.1) {
      points.row(0) = margin * points.row(0).cwiseAbs();
      EXPECT_FALSE(centred(points)) << "seed " << seed << ", margin " << margin;
    }
  }
}

}  // namespace
}  // namespace raygauge::test_centred_points
