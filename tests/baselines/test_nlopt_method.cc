// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/nlopt_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "generators/registry.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "tests/baselines/point_set_instances.h"

namespace raygauge::test_nlopt_method {
namespace {

MethodRegistry nlopt_methods() {
  MethodRegistry registry("method");
  register_nlopt_method(registry);
  return registry;
}

class NloptMethod : public ::testing::TestWithParam<std::string> {
 protected:
  DistanceResult run(const Instance& sets, const SolveRequest& request = {},
                     const Parameters& parameters = {}) {
    const auto method = nlopt_methods().make(GetParam(), parameters);
    method->load(sets);
    method->solve(request);
    return method->result();
  }
};

INSTANTIATE_TEST_SUITE_P(Baselines, NloptMethod, ::testing::ValuesIn(nlopt_methods().names()),
                         [](const auto& method) { return method.param; });

Instance two_balls() {
  return {std::make_shared<Ball>((Vector(3) << 3, 4, 0).finished(), 1.0),
          std::make_shared<Ball>((Vector(3) << 0.5, 0, 0).finished(), 2.0),
          {}};
}

// ‖c_A - λ c_Q‖ = r_A + λ r_Q, a quadratic equation in λ: 3.75 λ² + 7 λ - 24 = 0.
const double kTwoBalls = (std::sqrt(409.0) - 7) / 7.5;

TEST_P(NloptMethod, FindsTheDistanceOfTwoBalls) {
  const DistanceResult result = run(two_balls());
  EXPECT_EQ(to_string(result.status), "optimal");
  EXPECT_NEAR(result.distance, kTwoBalls, 1e-5);
}

TEST_P(NloptMethod, FindsTheDistanceOfABoxInTheGaugeOfABall) {
  const Instance sets{std::make_shared<Box>((Vector(2) << 3, -1).finished(), (Vector(2) << 5, 1).finished()),
                      std::make_shared<Ball>(Vector::Zero(2), 1.0),
                      {}};
  EXPECT_NEAR(run(sets).distance, 3, 1e-5);
}

// A general-purpose solver may miss or give up; that it mostly does not is what makes it a competitor.
TEST_P(NloptMethod, SolvesNearlyAllPairsOfExample1) {
  GeneratorRegistry generators("generator");
  register_generators(generators);
  int good = 0;
  constexpr int kPairs = 40;
  for (int repetition = 0; repetition < kPairs; ++repetition) {
    const Instance sets = generators.make("example1", {{"distance", 2.0}})->generate({1, 3, 1, repetition});
    const DistanceResult result = run(sets, {1e-6});
    good += result.status == DistanceStatus::optimal && std::abs(result.distance - 2) <= 2e-5;
  }
  EXPECT_GE(good, kPairs * 9 / 10);
}

TEST_P(NloptMethod, ProvesNothing) {
  const DistanceResult result = run(two_balls());
  EXPECT_TRUE(std::isnan(result.lower));
  EXPECT_TRUE(std::isnan(result.upper));
  EXPECT_GT(result.counters.pivots, 0);
}

TEST_P(NloptMethod, SaysWhenItsEvaluationsAreSpent) {
  EXPECT_EQ(to_string(run(two_balls(), {1e-12}, {{"max_evaluations", std::int64_t{2}}}).status),
            "iteration_limit");
}

TEST_P(NloptMethod, StartsEverySolveCold) {
  const auto method = nlopt_methods().make(GetParam(), {});
  method->load(two_balls());
  method->solve({});
  const DistanceResult first = method->result();
  method->solve({});
  EXPECT_EQ(method->result().distance, first.distance);
  EXPECT_EQ(method->result().counters, first.counters);
}

TEST_P(NloptMethod, RefusesPointSetsInOneLine) {
  try {
    run(testing::two_spheres(1, 3, 10));
    FAIL() << "it took point sets";
  } catch (const InvalidParameterError& error) {
    EXPECT_EQ(std::string(error.what()),
              "method '" + GetParam() +
                  "' takes ellipsoids and balls that are not flat, boxes and truncated "
                  "cones only, and A is none of these");
  }
}

}  // namespace
}  // namespace raygauge::test_nlopt_method
