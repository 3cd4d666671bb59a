// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_distance_between {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRounding = 1e-12;

class DistanceBetween : public ProgramTest {
 protected:
  void SetUp() override {
    write("square.csv", "0 0\n2 0\n0 2\n2 2\n");
    write("near.csv", "1.5 0.5\n4 0.5\n1.5 1\n4 1\n");
    write("far.csv", "5 0\n6 0\n5 2\n6 2\n");
    write("ball.toml", "shape = \"ball\"\ncenter = [1, 1]\nradius = 0.25\n");
    write("metric.csv", "0.25 1\n0.25 -1\n-0.25 1\n-0.25 -1\n");
  }

  Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "distance");
    arguments.insert(arguments.end(), {"--between", "--json"});
    const ProgramResult result = run_raygauge(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out);
  }
};

TEST_F(DistanceBetween, OfObjectsApartIsTheirDistance) {
  const Json json = json_of({"square.csv", "far.csv", "--signed", "--witness"});
  EXPECT_NEAR(json["distance"].get<double>(), 3, 1e-5);
  EXPECT_EQ(json["status"], "optimal");
  EXPECT_EQ(json["meet"], false);
  EXPECT_NEAR(json["point_1"][0].get<double>(), 2, 1e-5);
  EXPECT_NEAR(json["point_2"][0].get<double>(), 5, 1e-5);
}

TEST_F(DistanceBetween, OfObjectsThatMeetIsMinusTheirDepthIfSigned) {
  const Json json = json_of({"square.csv", "near.csv", "--signed", "--witness"});
  EXPECT_NEAR(json["distance"].get<double>(), -0.5, kRounding);
  EXPECT_LE(json["lower"].get<double>(), -0.5);
  EXPECT_GE(json["upper"].get<double>(), -0.5);
  EXPECT_EQ(json["status"], "optimal");
  EXPECT_EQ(json["meet"], true);
  EXPECT_NEAR(json["normal"][0].get<double>(), -1, kRounding);
  EXPECT_NEAR(json["point_2"][0].get<double>() - json["point_1"][0].get<double>(), -0.5, kRounding);
  const Json plain = json_of({"square.csv", "near.csv"});
  EXPECT_EQ(plain["distance"], 0.0);
  EXPECT_EQ(plain["status"], "contains_origin");
  EXPECT_FALSE(plain.contains("point_1"));
}

TEST_F(DistanceBetween, OfAHalfPlaneHasAClosedForm) {
  write("below.toml", "shape = \"half_space\"\nnormal = [0, 2]\noffset = -1\n");
  EXPECT_NEAR(json_of({"ball.toml", "below.toml"})["distance"].get<double>(), 1.25, kRounding);
  write("above.toml", "shape = \"half_space\"\nnormal = [0, -1]\noffset = -1\n");
  const Json json = json_of({"square.csv", "above.toml", "--signed"});
  EXPECT_NEAR(json["distance"].get<double>(), -1, kRounding);
  EXPECT_NEAR(json["normal"][1].get<double>(), -1, kRounding);
  const ProgramResult refused = run_raygauge({"distance", "ball.toml", "below.toml"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("half-space is not bounded"), std::string::npos) << refused.err;
}

TEST_F(DistanceBetween, TakesASetForTheMetric) {
  const Json json = json_of({"square.csv", "near.csv", "--signed", "--metric", "metric.csv"});
  EXPECT_NEAR(json["distance"].get<double>(), -1, kRounding);  // up or down, 1; along x four times 0.5
  EXPECT_NEAR(json_of({"square.csv", "far.csv", "--metric", "metric.csv"})["distance"].get<double>(), 12,
              1e-4);
}

TEST_F(DistanceBetween, SaysInWordsWhereToGo) {
  const ProgramResult result = run_raygauge({"distance", "ball.toml", "square.csv", "--between", "--signed"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("distance   -1.25"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("the objects overlap"), std::string::npos) << result.out;
}

TEST_F(DistanceBetween, RefusesWhatItHasNoUseFor) {
  for (const auto& [options, cause] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--signed"}, "--signed is for the distance of two objects: add --between"},
           {{"--metric", "metric.csv"}, "--metric is for the distance of two objects: add --between"},
           {{"--between", "--method", "glpk"}, "takes a set and a gauge"}}) {
    std::vector<std::string> arguments = {"distance", "square.csv", "near.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramResult result = run_raygauge(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find(cause), std::string::npos) << result.err;
  }
  write("flat.csv", "1 2 3\n");
  const ProgramResult result = run_raygauge({"distance", "square.csv", "flat.csv", "--between"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("same dimension"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace raygauge::testing::test_distance_between
