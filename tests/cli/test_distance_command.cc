// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "cli/input/registries.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_distance_command {
namespace {

using Json = nlohmann::ordered_json;

/// A certified interval is rounded outwards by a few units in the last place; nothing here needs more.
constexpr double kRounding = 1e-14;

constexpr const char* kCube = "1 1 1\n1 1 -1\n1 -1 1\n1 -1 -1\n-1 1 1\n-1 1 -1\n-1 -1 1\n-1 -1 -1\n";
constexpr const char* kCrossPolytope = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n";
/// The box [3, 4] x [2, 5].
constexpr const char* kBox = "3,2\n4,2\n3,5\n4,5\n";

void expect_answer(const Json& json, double distance) {
  EXPECT_EQ(json["status"], "optimal");
  EXPECT_NEAR(json["distance"].get<double>(), distance, kRounding * distance);
  EXPECT_LE(json["lower"].get<double>(), distance);
  EXPECT_GE(json["upper"].get<double>(), distance);
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

/// 500 random points in the cube [-1, 1]^20, shifted along the first axis: too much for a few basis changes.
std::string cloud(unsigned seed, double shift) {
  constexpr int kPoints = 500;
  constexpr int kDimension = 20;
  std::minstd_rand random(seed);
  std::ostringstream text;
  for (int i = 0; i < kPoints; ++i) {
    for (int k = 0; k < kDimension; ++k) {
      text << (k == 0 ? shift : 0) + 2.0 * random() / std::minstd_rand::max() - 1 << ' ';
    }
    text << '\n';
  }
  return text.str();
}

std::vector<std::string> methods_for_point_sets() {
  const MethodRegistry all = cli::all_methods();
  std::vector<std::string> names;
  for (const std::string& name : all.names()) {
    if (all.find(name).point_sets) names.push_back(name);
  }
  return names;
}

class EveryMethod : public DistanceProgram, public ::testing::WithParamInterface<std::string> {};

TEST_P(EveryMethod, AgreesWithTheMaximumNormOfAPoint) {
  expect_answer(run_json("3 1 -2\n", kCube, {"--method", GetParam()}), 3);
}

TEST_P(EveryMethod, AgreesWithTheOneNormOfAPoint) {
  expect_answer(run_json("3 1 -2\n", kCrossPolytope, {"--method", GetParam()}), 6);
}

TEST_P(EveryMethod, AgreesWithTheDistanceOfTwoBoxes) {
  expect_answer(run_json(kBox, "2 1\n2 -1\n-2 1\n-2 -1\n", {"--method", GetParam()}), 2);
}

INSTANTIATE_TEST_SUITE_P(Distance, EveryMethod, ::testing::ValuesIn(methods_for_point_sets()),
                         [](const auto& method) { return method.param; });

class DistanceCommand : public DistanceProgram {};

TEST_F(DistanceCommand, PrintsTheDocumentedKeysInTheirOrder) {
  const Json json = run_json(kBox, kSquare);
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"distance", "lower", "upper", "status",
                                                     "violated_preconditions", "unchecked_preconditions",
                                                     "method", "tolerance", "seconds", "check_seconds", "n",
                                                     "n_points_A", "n_points_Q", "normal", "counters"}));
  EXPECT_EQ(
      keys_of(json["counters"]),
      (std::vector<std::string>{"outer_iterations", "ray_iterations", "pivots", "support_queries",
                                "points_priced", "refactorisations", "exact_pivots", "witness_evaluations"}));
  EXPECT_EQ(json["method"], "column_generation");
  EXPECT_EQ(json["n"], 2);
  EXPECT_EQ(json["n_points_A"], 4);
  EXPECT_EQ(json["n_points_Q"], 4);
}

TEST_F(DistanceCommand, TheNormalProvesTheLowerBound) {
  const Json json = run_json("3 1 -2\n4 2 0\n", kCrossPolytope);
  const auto u = json["normal"].get<std::vector<double>>();
  ASSERT_EQ(u.size(), 3U);
  const double h_A = std::max(3 * u[0] + u[1] - 2 * u[2], 4 * u[0] + 2 * u[1]);
  const double h_Q = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
  EXPECT_NEAR(h_Q, 1, kRounding);
  EXPECT_NEAR(-h_A / h_Q, json["lower"].get<double>(), 6 * kRounding);
}

TEST_F(DistanceCommand, TheWitnessIsThePointWhereTheScaledSetTouches) {
  const Json json = run_json("2 0\n4 1\n4 -1\n", kDiamond, {"--witness"});
  const auto contact = json["contact_point"].get<std::vector<double>>();
  ASSERT_EQ(contact.size(), 2U);
  EXPECT_NEAR(contact[0], 2, 2 * kRounding);
  EXPECT_NEAR(contact[1], 0, 2 * kRounding);
  EXPECT_EQ(json["counters"]["witness_evaluations"], 1);
}

TEST_F(DistanceCommand, ASetThatContainsTheOriginHasDistanceZero) {
  const Json json = run_json(kSquare, kDiamond);
  EXPECT_EQ(json["status"], "contains_origin");
  EXPECT_EQ(json["distance"], 0);
  const ProgramResult text = run(kSquare, kDiamond);
  EXPECT_NE(text.out.find("A contains the origin: the distance is 0"), std::string::npos) << text.out;
}

TEST_F(DistanceCommand, WhatNoMultipleReachesIsInfinitelyFarAndProven) {
  const Json json = run_json("-1 -1\n-2 1\n", "1 1\n2 -1\n");
  EXPECT_EQ(json["status"], "unreachable");
  EXPECT_EQ(json["distance"], "inf");
  EXPECT_EQ(json["upper"], "inf");
  const auto u = json["normal"].get<std::vector<double>>();
  ASSERT_EQ(u.size(), 2U);
  EXPECT_LT(std::max(-u[0] - u[1], -2 * u[0] + u[1]), 0) << "h_A(u)";
  EXPECT_LE(std::max(-u[0] - u[1], -2 * u[0] + u[1]), 0) << "h_Q(-u)";
  const ProgramResult text = run("-1 -1\n-2 1\n", "1 1\n2 -1\n");
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("no multiple of Q meets A"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("the origin is not in the interior of Q"), std::string::npos) << text.out;
}

TEST_F(DistanceCommand, TextTellsSeparationContactAndPenetration) {
  const auto verdict_on = [this](const std::string& A) { return run(A, kSquare).out; };
  EXPECT_NE(verdict_on("2 0\n3 0\n").find("separated"), std::string::npos);
  EXPECT_NE(verdict_on("1 0\n3 0\n").find("in contact"), std::string::npos);
  EXPECT_NE(verdict_on("0.5 0\n3 0\n").find("penetrating"), std::string::npos);
}

TEST_F(DistanceCommand, ContactIsNotClaimedOfBoundsThatMissOne) {
  // At d = 1.001 a tolerance of 1e-6 tells the sets apart.
  const std::string text = run("1.001 0\n3 0\n", kSquare).out;
  EXPECT_EQ(text.find("in contact"), std::string::npos) << text;
  EXPECT_NE(text.find("separated"), std::string::npos) << text;
}

TEST_F(DistanceCommand, AnIterationLimitEndsWithStatusThreeAndBounds) {
  for (const char* method : {"column_generation", "zheng_yamane"}) {
    const ProgramResult outcome =
        run(cloud(1, 5), cloud(2, 0), {"--method", method, "--max-iterations", "1", "--json"});
    EXPECT_EQ(outcome.status, 3) << method << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["status"], "iteration_limit") << method;
    EXPECT_LT(number(json["lower"]), number(json["upper"])) << method;
  }
}

TEST_F(DistanceCommand, ATimeLimitOfZeroEndsWithStatusThree) {
  // `column_generation` answers this within the pivots that it makes before it first looks at the clock.
  const ProgramResult outcome =
      run(cloud(1, 5), cloud(2, 0), {"--method", "zheng_yamane", "--time-limit", "0"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("stopped at the time limit"), std::string::npos) << outcome.out;
}

TEST_F(DistanceCommand, OneSetMayComeFromStandardInput) {
  write("Q.csv", kSquare);
  const ProgramResult outcome = run_raygauge({"distance", "-", "Q.csv", "--json"}, "3 1\n4 -1\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_answer(Json::parse(outcome.out), 3);
  expect_complaint(run_raygauge({"distance", "-", "Q.csv"}, "3 x\n"),
                   "raygauge: standard input:1:3: 'x' is not a number");
}

#ifdef RAYGAUGE_HAS_GLPK
TEST_F(DistanceCommand, GlpkStandsForItsDualSimplex) {
  EXPECT_EQ(run_json(kBox, kSquare, {"--method", "glpk"})["method"], "glpk_dual");
}
#endif

TEST_F(DistanceCommand, ThePublishedStopRuleAndEveryKernelAnswer) {
  expect_answer(run_json(kBox, kSquare, {"--method", "zheng_yamane", "--stop-rule", "published_sigma"}), 3);
  expect_answer(run_json(kBox, kSquare, {"--instruction-set", "baseline"}), 3);
}

}  // namespace
}  // namespace raygauge::testing::test_distance_command
