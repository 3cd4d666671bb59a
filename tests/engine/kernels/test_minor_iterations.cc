// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Basis changes that a tableau in single precision proposes: solves agree whatever proposes them.
#include <gtest/gtest.h>

#include <string>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_minor_iterations {
namespace {

class MinorIterations : public ::testing::TestWithParam<InstructionSet> {
 protected:
  // The portable kernels have no tableau.
  void expect_same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& q) {
    const PointSet A(a);
    const PointSet Q(q);
    options_.instruction_set = InstructionSet::baseline;
    const DistanceResult expected = DistanceSolver(options_).solve(A, Q);
    options_.instruction_set = GetParam();
    const DistanceResult result = DistanceSolver(options_).solve(A, Q);
    ASSERT_EQ(result.status, expected.status) << "n = " << a.rows() << ", N = " << a.cols();
    ASSERT_LE(result.lower, expected.upper);
    ASSERT_GE(result.upper, expected.lower);
    if (result.status != DistanceStatus::optimal) return;
    ASSERT_LE(result.upper - result.lower, options_.tolerance * result.upper);
  }

  DistanceOptions options_;
};

INSTANTIATE_TEST_SUITE_P(Machine, MinorIterations, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

TEST_P(MinorIterations, AgreeOnFewPointsAndMany) {
  Random random(31);
  for (int n = 2; n <= 11; ++n) {
    for (const int N : {1, 2, 7, 8, 9, 15, 16, 17, 40, 300, 2500}) {
      Eigen::MatrixXd a = gaussian_points(n, N, random);
      a.row(0).array() += 6;
      expect_same(a, gaussian_points(n, N, random));
    }
  }
}

// Every ratio test has ties, most basic variables are zero, and every column is there many times.
TEST_P(MinorIterations, AgreeOnLattices) {
  Random random(32);
  for (int n = 2; n <= 10; ++n) {
    for (const int N : {20, 200}) {
      Eigen::MatrixXd a = integer_points(n, N, 1, random);
      a.row(0).array() += 4;
      Eigen::MatrixXd q = integer_points(n, N, 1, random);
      expect_same(a, q);
      a.rightCols(N / 2) = a.leftCols(N / 2).eval();
      q.rightCols(N / 2) = q.leftCols(N / 2).eval();
      expect_same(a, q);
    }
  }
}

// Entries of the inverse up to 1e9: single precision says little about the row that leaves.
TEST_P(MinorIterations, AgreeOnNeedles) {
  Random random(33);
  for (int n = 2; n <= 10; ++n) {
    for (const double thickness : {1e-3, 1e-6, 1e-9}) {
      Eigen::MatrixXd a = gaussian_points(n, 150, random);
      Eigen::MatrixXd q = gaussian_points(n, 150, random);
      a.row(n - 1) *= thickness;
      q.row(n - 1) *= thickness;
      a.row(0).array() += 6;
      expect_same(a, q);
    }
  }
}

// A wedge that A is behind: columns without a row that leaves, and no artificial column can.
TEST_P(MinorIterations, AgreeThatAWedgeDoesNotReach) {
  Random random(34);
  for (int n = 2; n <= 10; ++n) {
    Eigen::MatrixXd q = gaussian_points(n, 60, random);
    q.row(0) = q.row(0).cwiseAbs();
    Eigen::MatrixXd a = gaussian_points(n, 60, random);
    a.row(0) = -a.row(0).cwiseAbs().array() - 1;
    expect_same(a, q);
  }
}

}  // namespace
}  // namespace raygauge::test_minor_iterations
