// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge distance`, as a user runs it, on the families that no formula forgives: the status and the
// distance of each row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "tests/cli/program_fixture.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::testing::test_distance_hard_cases {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Eigen::MatrixXd& points) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) text << (k > 0 ? "," : "") << points(k, i);
    text << "\n";
  }
  return text.str();
}

std::string status_of(double exact_distance) {
  if (exact_distance == 0) return "contains_origin";
  return std::isinf(exact_distance) ? "unreachable" : "optimal";
}

class HardRow : public DistanceProgram, public ::testing::WithParamInterface<HardCase> {};

TEST_P(HardRow, HasItsStatusAndItsDistance) {
  for (const int n : {2, 3}) {
    const Instance instance = generate(GetParam().generator, {6, n, 30, 0}, GetParam().parameters);
    const std::string A = text_of(points_of(instance.A)), Q = text_of(points_of(instance.Q));
    const double d = instance.exact_distance.value();
    for (const char* method : {"column_generation", "zheng_yamane"}) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", " + method);
      const Json json = run_json(A, Q, {"--tolerance", "1e-12", "--method", method});
      EXPECT_EQ(json["status"], status_of(d));
      // 1/δ is no double: there the generator's distance is the nearest one.
      EXPECT_LE(number(json["lower"]), GetParam().rounded ? std::nextafter(d, 2 * d) : d);
      EXPECT_GE(number(json["upper"]), GetParam().rounded ? std::nextafter(d, 0) : d);
    }
  }
}

constexpr const char* kBesideOrigin = "1 1\n1 -1\n2 0\n";   // row 20
constexpr const char* kThroughOrigin = "0 1\n0 -1\n2 0\n";  // row 19

class HardAnswer : public DistanceProgram {
 protected:
  std::vector<std::string> violated(const std::string& A, const std::string& Q) {
    return run_json(A, Q)["violated_preconditions"].get<std::vector<std::string>>();
  }
};

TEST_F(HardAnswer, NamesTheViolatedPreconditionWhetherOrNotQReachesA) {
  const std::vector<std::string> kNamed = {"origin_in_interior_of_Q"};
  EXPECT_EQ(violated("3 1\n", kBesideOrigin), kNamed);
  EXPECT_EQ(violated("1 3\n", kBesideOrigin), kNamed);
  EXPECT_EQ(violated("3 1\n", kThroughOrigin), kNamed);
  EXPECT_EQ(violated("3 1\n", "1 0\n-1 0\n"), kNamed);  // flat
  EXPECT_TRUE(violated("3 1\n", kSquare).empty());
  EXPECT_NE(run("3 1\n", kBesideOrigin).out.find("the origin is not in the interior of Q"),
            std::string::npos);
}

TEST_F(HardAnswer, ProvesThatAContainsTheOriginByWeights) {
  const Json json = run_json("-1 -1\n5 5\n1 -1\n0 2\n", kSquare);
  EXPECT_EQ(json["status"], "contains_origin");
  const std::vector<Vector> A = {Vector::Constant(2, -1.0), Vector::Constant(2, 5.0),
                                 (Vector(2) << 1, -1).finished(), (Vector(2) << 0, 2).finished()};
  Vector sum = Vector::Zero(2);
  double total = 0;
  for (const auto& entry : json["origin_weights"]) {
    EXPECT_GE(entry["weight"].get<double>(), 0);
    sum += entry["weight"].get<double>() * A.at(entry["point"].get<std::size_t>());
    total += entry["weight"].get<double>();
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-15);
  EXPECT_NEAR(total, 1, 1e-15);
  EXPECT_NE(run("-1 -1\n1 1\n", kSquare).out.find("0 = 0.5 a_"), std::string::npos);
}

// A face at 1e-300 from the origin is not a face through it.
TEST_F(HardAnswer, TellsAFaceNearTheOriginFromOneThroughIt) {
  const Json near = run_json("1e-300 1\n1e-300 -1\n1 0\n", kSquare);
  EXPECT_EQ(near["status"], "optimal");
  EXPECT_EQ(near["distance"], 1e-300);
  EXPECT_EQ(run_json("0 1\n0 -1\n1 0\n", kSquare)["status"], "contains_origin");
}

// Row 32.
TEST_F(HardAnswer, RejectsWhatIsNoSet) {
  for (const char* text : {"nan 1\n", "1 inf\n", "", "1 2\n3\n", "1e999 1\n"}) {
    const ProgramResult outcome = run(text, kSquare);
    EXPECT_EQ(outcome.status, 2) << text;
    EXPECT_EQ(outcome.out, "") << text;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, HardRow, ::testing::ValuesIn(hard_cases()),
                         [](const auto& row) { return label(row.param); });

}  // namespace
}  // namespace raygauge::testing::test_distance_hard_cases
