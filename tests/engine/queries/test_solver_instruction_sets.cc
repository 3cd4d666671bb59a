// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "raygauge/exceptions.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_instruction_sets {
namespace {

class InstructionSets : public BothMethods {
 protected:
  // The certificates of all instruction sets: each closed to the tolerance, all holding a common number.
  static void expect_agreement(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q, double tolerance) {
    const PointSet points_A(A);
    const PointSet points_Q(Q);
    double highest_lower = 0;
    double lowest_upper = std::numeric_limits<double>::infinity();
    for (const InstructionSet isa : instruction_sets_here()) {
      DistanceOptions forced = options(tolerance);
      forced.instruction_set = isa;
      DistanceSolver solver(forced);
      const DistanceResult& result = solver.solve(points_A, points_Q);
      EXPECT_EQ(result.status, DistanceStatus::optimal) << to_string(isa);
      EXPECT_LE(result.upper - result.lower, tolerance * result.upper) << to_string(isa);
      highest_lower = std::max(highest_lower, result.lower);
      lowest_upper = std::min(lowest_upper, result.upper);
    }
    EXPECT_LE(highest_lower, lowest_upper);
  }
};
RAYGAUGE_BOTH_METHODS(InstructionSets);

TEST_P(InstructionSets, AgreeOnRandomSets) {
  Random random(81);
  for (const int n : {1, 2, 3, 5, 8, 9, 10, 11, 17, 20}) {
    for (const int N : {4 * n + 3, 900}) {
      Eigen::MatrixXd A = sphere_points(n, N, random);
      A.row(0).array() += 3;
      const Eigen::MatrixXd Q = sphere_points(n, N, random);
      expect_agreement(A, Q, 1e-6);
      expect_agreement(A, Q, 1e-12);
    }
  }
}

TEST_P(InstructionSets, AgreeOnClusteredSets) {
  Random random(82);
  for (const int n : {2, 3, 6, 10}) {
    Eigen::MatrixXd A = clustered_points(n, 400, random);
    A.row(0).array() += 4;
    expect_agreement(A, clustered_points(n, 400, random), 1e-9);
  }
}

TEST_P(InstructionSets, AgreeOnLatticesCubesAndRepeatedPoints) {
  for (const int n : {2, 3, 4}) {
    const Eigen::MatrixXd lattice = lattice_points(n, 4).array() + 0.5;
    expect_agreement(lattice, cube_vertices(n), 1e-12);
    expect_agreement(lattice, lattice.array() - 2.25, 1e-12);
    expect_agreement(lattice.replicate(1, 7), cube_vertices(n).replicate(1, 20), 1e-12);
  }
}

TEST_P(InstructionSets, RefuseToBeForcedOnAMachineThatLacksThem) {
  const auto here = instruction_sets_here();
  for (const InstructionSet isa : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    DistanceOptions forced = options(1e-6);
    forced.instruction_set = isa;
    if (std::find(here.begin(), here.end(), isa) != here.end()) {
      EXPECT_NO_THROW(DistanceSolver{forced});
    } else {
      EXPECT_THROW(DistanceSolver{forced}, InvalidParameterError);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_solver_instruction_sets
