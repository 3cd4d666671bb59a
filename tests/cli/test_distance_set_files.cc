// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge distance` on sets that are not given by points.
#include <gtest/gtest.h>

#include <cmath>

#include "cli/input/registries.h"
#include "cli/input/shapes.h"
#include "engine/numerics/number_text.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_distance_set_files {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kUnitBall = "shape = \"ball\"\ncenter = [0, 0]\nradius = 1\n";
/// At 3 from the origin.
constexpr const char* kCapsule = "shape = \"capsule\"\np = [4, -1]\nq = [4, 2]\nradius = 1\n";

class DistanceOfSetFiles : public ProgramTest {
 protected:
  ProgramResult run(const std::string& A, const std::string& Q, std::vector<std::string> options = {}) {
    write("A.toml", A);
    write("Q.toml", Q);
    options.insert(options.begin(), {"distance", "A.toml", "Q.toml"});
    return run_raygauge(options);
  }

  Json run_json(const std::string& A, const std::string& Q, std::vector<std::string> options = {}) {
    options.emplace_back("--json");
    const ProgramResult outcome = run(A, Q, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(DistanceOfSetFiles, IsCertifiedByEachOfOurMethods) {
  for (const char* method : {"column_generation", "zheng_yamane", "newton"}) {
    const Json json = run_json(kCapsule, kUnitBall, {"--method", method, "--tolerance", "1e-9", "--witness"});
    EXPECT_EQ(json["status"], "optimal") << method;
    EXPECT_LE(json["lower"], 3) << method;
    EXPECT_GE(json["upper"], 3) << method;
    EXPECT_NEAR(json["contact_point"][0].get<double>(), 3, 1e-8) << method;
  }
}

TEST_F(DistanceOfSetFiles, LeavesTheNumberOfPointsOpen) {
  const Json json = run_json(kCapsule, "shape = \"point_set\"\npoints = [[1, 1], [1, -1], [-1, 0]]");
  EXPECT_TRUE(json["n_points_A"].is_null());
  EXPECT_EQ(json["n_points_Q"], 3);
  EXPECT_EQ(json["n"], 2);
  EXPECT_NE(run(kCapsule, kUnitBall).out.find("\nsets       n = 2, smooth A, smooth Q\n"), std::string::npos);
}

TEST_F(DistanceOfSetFiles, MeetsPointsFromAFileOrStandardInput) {
  write("Q.toml", kUnitBall);
  const ProgramResult outcome = run_raygauge({"distance", "-", "Q.toml", "--json"}, "3 4\n6 8\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(Json::parse(outcome.out)["distance"].get<double>(), 5, 5e-6);
}

TEST_F(DistanceOfSetFiles, SaysWhereNothingProvesTheOriginInsideQ) {
  const std::string text = run("shape = \"point_set\"\npoints = [[0, 1]]",
                               "shape = \"ellipsoid\"\ncenter = [1, 0]\nfactor = [[1, 0], [0, 1]]")
                               .out;
  EXPECT_NE(text.find("\nunproven   the origin was not found to be in the interior of Q"), std::string::npos)
      << text;
  EXPECT_EQ(run(kCapsule, kUnitBall).out.find("unproven"), std::string::npos);
}

TEST_F(DistanceOfSetFiles, NamesTheViolatedPreconditionOfWhatIsOutOfReach) {
  const Json json = run_json("shape = \"ball\"\ncenter = [-3, 0]\nradius = 1",
                             "shape = \"ball\"\ncenter = [3, 0]\nradius = 1");
  EXPECT_EQ(json["status"], "unreachable");
  EXPECT_EQ(json["violated_preconditions"][0], "origin_in_interior_of_Q");
}

TEST_F(DistanceOfSetFiles, IsThatOfTheSamePointsByEveryMethod) {
  const MethodRegistry methods = cli::all_methods();
  for (const std::string& name : methods.names()) {
    if (!methods.find(name).point_sets) continue;
    const Json json =
        run_json("shape = \"point_set\"\npoints = [[3, 1], [4, 0]]",
                 "shape = \"point_set\"\npoints = [[1, 0], [-1, 0], [0, 1], [0, -1]]", {"--method", name});
    EXPECT_NEAR(json["distance"].get<double>(), 4, 1e-12) << name;
  }
}

#ifdef RAYGAUGE_HAS_EXACT
TEST_F(DistanceOfSetFiles, IsRefusedByMethodsThatTakePointsOnly) {
  expect_complaint(run(kCapsule, kUnitBall, {"--method", "exact"}),
                   "raygauge: method 'exact' takes point sets only, and A is not a point set");
}
#endif

#ifdef RAYGAUGE_HAS_NLOPT
TEST_F(DistanceOfSetFiles, IsFoundWithoutProofByAGeneralOptimizer) {
  const ProgramResult outcome =
      run("shape = \"ball\"\ncenter = [3, 4]\nradius = 1", kUnitBall, {"--method", "nlopt_slsqp", "--json"});
  ASSERT_NE(outcome.status, 2) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json["distance"].get<double>(), 4, 1e-5);
  EXPECT_TRUE(json["lower"].is_null());
}
#endif

TEST_F(DistanceOfSetFiles, NeedsOneDimension) {
  expect_complaint(run("shape = \"ball\"\ncenter = [1, 2, 3]\nradius = 0", kUnitBall),
                   "raygauge: A and Q must have the same dimension: A.toml has n = 3, Q.toml has n = 2");
}

TEST_F(DistanceOfSetFiles, EndsWithOneLineOnBadInput) {
  expect_complaint(run("shape = \"ball\"\ncenter = [1, 2]\nradius = -1", kUnitBall),
                   "raygauge: A.toml:1: ball: radius must not be negative, got -1");
  expect_complaint(run(kCapsule, ""), "raygauge: Q.toml:1: a set needs a shape, as in shape = \"ball\"");
  expect_complaint(run_raygauge({"distance", "none.toml", "A.toml"}),
                   "raygauge: none.toml: No such file or directory");
}

TEST_F(DistanceOfSetFiles, AreDescribedByHelpAndInfo) {
  const std::string help = run_raygauge({"distance", "--help"}).out, info = run_raygauge({"info"}).out;
  const Json listed = Json::parse(run_raygauge({"info", "--json"}).out)["shapes"];
  ASSERT_EQ(listed.size(), cli::shapes().size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const cli::Shape& shape = cli::shapes()[i];
    EXPECT_EQ(listed[i]["name"], shape.name);
    EXPECT_NE(help.find("\n  " + shape.name + " "), std::string::npos) << shape.name;
    for (const cli::ShapeParameter& parameter : shape.parameters) {
      EXPECT_EQ(listed[i]["parameters"][parameter.name]["type"], parameter.type);
      const std::string usual = parameter.usual ? " = " + rounded_text(*parameter.usual, 3) : "";
      EXPECT_NE(info.find("\n      " + parameter.name + usual + ": " + parameter.type), std::string::npos)
          << parameter.name;
    }
  }
}

}  // namespace
}  // namespace raygauge::testing::test_distance_set_files
