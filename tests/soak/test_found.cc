// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Every instance that a soak once saw answered falsely, in found/NAME/{A,Q}.csv, with every method, tolerance
// and instruction set.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "tests/engine/instruction_sets.h"
#include "tests/soak/certificate_check.h"
#include "tests/soak/proven_instance.h"
#include "tests/soak/run.h"

namespace raygauge::test_found {
namespace {

std::vector<std::string> found_instances() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(RAYGAUGE_FOUND_FOLDER)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

class FoundInstance : public testing::TestWithParam<std::string> {};

TEST_P(FoundInstance, IsAnsweredTruly) {
  const std::string folder = RAYGAUGE_FOUND_FOLDER "/" + GetParam();
  const auto proven =
      soak::prove(GetParam(), soak::load_points(folder + "/A.csv"), soak::load_points(folder + "/Q.csv"));
  const soak::Truth truth{proven.truth.status, proven.truth.rounded};
  const PointSet A(proven.A), Q(proven.Q);
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const DistanceMethod method : {DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
      for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
        DistanceOptions options;
        options.method = method;
        options.tolerance = tolerance;
        options.instruction_set = isa;
        DistanceSolver solver(options);
        EXPECT_EQ(soak::falsehood(solver.solve(A, Q), truth, tolerance), "")
            << to_string(method) << ", " << to_string(isa) << ", tolerance " << tolerance;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Soak, FoundInstance, testing::ValuesIn(found_instances()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace raygauge::test_found
