// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/method.h"

namespace raygauge::test_engine_methods {
namespace {

/// A = the segment from (3, -1) to (3, 2), Q = the square [-1, 1]²: d = 3.
Instance segment_and_square() {
  Eigen::MatrixXd segment(2, 2);
  segment << 3, 3, -1, 2;
  Eigen::MatrixXd square(2, 4);
  square << -1, -1, 1, 1, -1, 1, -1, 1;
  return {std::make_shared<PointSet>(segment), std::make_shared<PointSet>(square), 3.0};
}

class EngineMethods : public ::testing::Test {
 protected:
  EngineMethods() { register_engine_methods(registry_); }

  MethodRegistry registry_{"method"};
};

TEST_F(EngineMethods, AllAreRegistered) {
  EXPECT_EQ(registry_.names(),
            (std::vector<std::string>{"column_generation", "newton", "object_distance", "zheng_yamane"}));
}

TEST_F(EngineMethods, SolveToTheRequestedTolerance) {
  const Instance instance = segment_and_square();
  for (const std::string& name : registry_.names()) {
    const auto method = registry_.make(name, {});
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      method->load(instance);
      method->solve({tolerance, 10});
      const DistanceResult result = method->result();
      EXPECT_EQ(result.status, DistanceStatus::optimal) << name;
      EXPECT_LE(result.lower, 3);
      EXPECT_GE(result.upper, 3);
      EXPECT_LE(result.upper - result.lower, tolerance * result.upper) << name;
    }
  }
}

TEST_F(EngineMethods, GiveWhatTheSolverGives) {
  const Instance instance = segment_and_square();
  DistanceOptions options;
  options.method = DistanceMethod::zheng_yamane;
  DistanceSolver solver(options);
  const DistanceResult expected = solver.solve(*instance.A, *instance.Q);
  const auto method = registry_.make("zheng_yamane", {});
  method->load(instance);
  method->solve({});
  EXPECT_EQ(method->result().lower, expected.lower);
  EXPECT_EQ(method->result().upper, expected.upper);
  EXPECT_EQ(method->result().counters, expected.counters);
}

TEST_F(EngineMethods, ARepeatedSolveGivesTheSameBits) {
  const Instance instance = segment_and_square();
  for (const std::string& name : registry_.names()) {
    const auto method = registry_.make(name, {});
    method->load(instance);
    method->solve({});
    const DistanceResult first = method->result();
    method->solve({});
    EXPECT_EQ(method->result().lower, first.lower) << name;
    EXPECT_EQ(method->result().counters, first.counters) << name;
  }
}

TEST_F(EngineMethods, TakeTheirParameters) {
  const auto published = registry_.make("zheng_yamane", {{"stop_rule", std::string("published_sigma")},
                                                         {"instruction_set", std::string("baseline")},
                                                         {"max_iterations", std::int64_t{1000}}});
  const Instance instance = segment_and_square();
  published->load(instance);
  published->solve({});
  EXPECT_NEAR(published->result().sigma, 1, 1e-6);
  EXPECT_NEAR(published->result().distance, 3, 3e-6);
}

TEST_F(EngineMethods, RejectWhatTheyDoNotKnow) {
  EXPECT_THROW(registry_.make("column_generation", {{"stop_rule", std::string("published_sigma")}}),
               UnknownNameError);
  EXPECT_THROW(registry_.make("column_generation", {{"instruction_set", std::string("mmx")}}),
               UnknownNameError);
  EXPECT_THROW(registry_.make("column_generation", {{"max_iterations", std::int64_t{-1}}}),
               InvalidParameterError);
}

TEST_F(EngineMethods, AResultNobodySolvedForIsAnError) {
  const auto method = registry_.make("column_generation", {});
  EXPECT_THROW(method->result(), Error);
}

}  // namespace
}  // namespace raygauge::test_engine_methods
