// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <ctime>
#include <thread>

#include "baselines/registry.h"
#include "engine/sweep/limited_load.h"
#include "raygauge/exceptions.h"
#include "tests/baselines/closed_forms.h"

// What every simplex of this build is held to; what only one of them has is tested in its own file.
namespace raygauge::testing::test_simplex_baselines {
namespace {

/// The tolerance of a default SolveRequest: all that a simplex which perturbs its bounds (Clp) promises.
constexpr double kAsked = SolveRequest{}.tolerance;

MethodRegistry baselines() {
  MethodRegistry registry("method");
  register_baselines(registry);
  return registry;
}

std::vector<std::string> simplex_names() {
  std::vector<std::string> names = baselines().names();
  std::erase_if(
      names, [](const std::string& name) { return !name.starts_with("glpk") && !name.starts_with("clp"); });
  return names;
}

/// The method's defaults, and every parameter changed in turn.
std::vector<Parameters> variants(const std::string& method) {
  std::vector<Parameters> result = {{}};
  const std::vector<ParameterInfo> parameters = baselines().find(method).parameters;
  for (const ParameterInfo& info : parameters) {
    if (std::holds_alternative<bool>(info.default_value)) result.push_back({{info.name, true}});
    for (const std::string& choice : info.choices) {
      if (ParameterValue(choice) != info.default_value) result.push_back({{info.name, choice}});
    }
  }
  return result;
}

DistanceResult run(const std::string& name, const Parameters& parameters, const Instance& sets,
                   const SolveRequest& request = {}) {
  const auto method = baselines().make(name, parameters);
  method->load(sets);
  method->solve(request);
  return method->result();
}

class SimplexBaseline : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Baselines, SimplexBaseline, ::testing::ValuesIn(simplex_names()),
                         [](const auto& method) { return method.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SimplexBaseline);

TEST_P(SimplexBaseline, MeetsClosedFormsInEveryVariant) {
  for (const ClosedForm& form : well_scaled_forms()) {
    for (const Parameters& variant : variants(GetParam())) {
      SCOPED_TRACE(form.name + " " + to_string(variant));
      const DistanceResult result = run(GetParam(), variant, form.sets);
      if (form.distance == kInf) {
        EXPECT_EQ(to_string(result.status), "unreachable");
        EXPECT_EQ(result.distance, kInf);
      } else {
        EXPECT_EQ(to_string(result.status), "optimal");
        EXPECT_NEAR(result.distance, form.distance, kAsked * (1 + form.distance));
      }
    }
  }
}

TEST_P(SimplexBaseline, CertifiesItsAnswerOnRandomSpheres) {
  for (const auto& [n, N] : {std::pair{2, 50}, {3, 400}, {7, 300}, {12, 60}}) {
    for (const Parameters& variant : variants(GetParam())) {
      SCOPED_TRACE("n = " + std::to_string(n) + " " + to_string(variant));
      const DistanceResult result = run(GetParam(), variant, two_spheres(7, n, N));
      EXPECT_EQ(to_string(result.status), "optimal");
      EXPECT_LE(result.upper - result.lower, kAsked * result.upper);
      EXPECT_GE(result.distance, result.lower * (1 - kAsked));
      EXPECT_LE(result.distance, result.upper * (1 + kAsked));
      EXPECT_GT(result.counters.pivots, 0);
    }
  }
}

TEST_P(SimplexBaseline, NormalHasUnitGaugeAndGivesTheLowerBound) {
  const Instance sets = two_spheres(3, 5, 100);
  const DistanceResult result = run(GetParam(), {}, sets);
  EXPECT_NEAR(sets.Q->support_function(-result.normal), 1, 1e-14);
  EXPECT_NEAR(-sets.A->support_function(result.normal), result.lower, 1e-14 * result.lower);
}

TEST_P(SimplexBaseline, NeverCertifiesAWrongBoundBelowItsTolerances) {
  for (const ClosedForm& form : below_tolerances()) {
    SCOPED_TRACE(form.name);
    const DistanceResult result = run(GetParam(), {}, form.sets);
    EXPECT_FALSE(result.lower > form.distance);
    EXPECT_FALSE(result.upper < form.distance);
  }
}

TEST_P(SimplexBaseline, EverySolveStartsColdAndRepeatsItself) {
  const auto method = baselines().make(GetParam(), {});
  method->load(two_spheres(1, 4, 200));
  method->solve({});
  const DistanceResult first = method->result();
  method->solve({});
  const DistanceResult second = method->result();
  EXPECT_EQ(first.distance, second.distance);
  EXPECT_EQ(first.counters, second.counters);
  EXPECT_EQ(first.lower, second.lower);
}

TEST_P(SimplexBaseline, ReportsATimeLimit) {
  const DistanceResult result = run(GetParam(), {}, two_spheres(1, 10, 20000), {1e-6, 1e-9});
  EXPECT_EQ(to_string(result.status), "time_limit");
}

/// Of this thread: wall time would tell what else the machine does.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST_P(SimplexBaseline, EndsAtTheTimeLimitHoweverLargeTheModel) {
  constexpr double kLimit = 0.05;
  const Instance sets = two_spheres(1, 3, 200000);
  for (const Parameters& variant : variants(GetParam())) {
    SCOPED_TRACE(to_string(variant));
    const auto method = baselines().make(GetParam(), variant);
    const double start = processor_seconds();
    limit_load(*method, kLimit);
    method->load(sets);
    method->solve({1e-6, kLimit});
    EXPECT_LT(processor_seconds() - start, 1.2 * kLimit + 0.1);
    EXPECT_EQ(to_string(method->result().status), "time_limit");
  }
}

TEST_P(SimplexBaseline, SolvesAModelThatIsBuiltWithinTheLimit) {
  for (const Parameters& variant : variants(GetParam())) {
    SCOPED_TRACE(to_string(variant));
    const auto method = baselines().make(GetParam(), variant);
    limit_load(*method, 60);
    for (int i = 0; i < 2; ++i) {
      method->load(two_spheres(1, 4, 200));
      method->solve({1e-6, 60});
      EXPECT_EQ(to_string(method->result().status), "optimal");
    }
  }
}

TEST_P(SimplexBaseline, AcceptsAnyToleranceOfARequest) {
  for (const double tolerance : {1e-300, 1e-12, 0.5, 1.0}) {
    const DistanceResult result = run(GetParam(), {}, two_spheres(2, 3, 100), {tolerance, kInf});
    EXPECT_EQ(to_string(result.status), "optimal") << tolerance;
  }
}

TEST_P(SimplexBaseline, ThreadsAgreeWithSerialBitForBit) {
  std::vector<double> serial(6), threaded(6);
  const auto solve = [&](std::vector<double>& out, size_t i) {
    out[i] = run(GetParam(), {}, two_spheres(i + 1, 3 + static_cast<int>(i), 150)).distance;
  };
  for (size_t i = 0; i < serial.size(); ++i) solve(serial, i);
  const auto share = [&](size_t first) {
    for (size_t i = first; i < threaded.size(); i += 2) solve(threaded, i);
  };
  std::thread one(share, 0), two(share, 1);
  one.join();
  two.join();
  EXPECT_EQ(serial, threaded);
}

TEST_P(SimplexBaseline, RefusesToSolveBeforeLoading) {
  const auto method = baselines().make(GetParam(), {});
  EXPECT_THROW(method->solve({}), Error);
  EXPECT_THROW(method->result(), Error);
}

}  // namespace
}  // namespace raygauge::testing::test_simplex_baselines
