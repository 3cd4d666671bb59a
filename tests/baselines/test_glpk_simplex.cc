// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/glpk_simplex.h"

#include <glpk.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/baselines/closed_forms.h"

namespace raygauge::testing {
namespace {

MethodRegistry glpk_methods() {
  MethodRegistry registry("method");
  register_glpk_methods(registry);
  return registry;
}

DistanceResult run(const std::string& name, const Parameters& parameters, const Instance& sets,
                   const SolveRequest& request = {}) {
  const auto method = glpk_methods().make(name, parameters);
  method->load(sets);
  method->solve(request);
  return method->result();
}

const std::vector<Parameters> kVariants = {
    {}, {{"presolve", true}}, {{"scale", true}}, {{"basis", std::string("advanced")}}};

/// Blocks of memory the GLPK environment of this thread holds. Asking makes an environment.
size_t allocated_bytes() {
  size_t bytes = 0;
  glp_mem_usage(nullptr, nullptr, &bytes, nullptr);
  return bytes;
}

class GlpkSimplex : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Both, GlpkSimplex, ::testing::Values("glpk_primal", "glpk_dual"),
                         [](const auto& method) { return std::string(method.param); });

TEST_P(GlpkSimplex, MeetsClosedFormsInEveryVariant) {
  for (const ClosedForm& form : well_scaled_forms()) {
    for (const Parameters& variant : kVariants) {
      SCOPED_TRACE(form.name + " " + to_string(variant));
      const DistanceResult result = run(GetParam(), variant, form.sets);
      if (form.distance == kInf) {
        EXPECT_EQ(result.status, DistanceStatus::unreachable);
        EXPECT_EQ(result.distance, kInf);
      } else {
        EXPECT_EQ(result.status, DistanceStatus::optimal);
        EXPECT_NEAR(result.distance, form.distance,
                    1e-12 * (1 + form.distance));  // rounding in n <= 9 pivots
      }
    }
  }
}

TEST_P(GlpkSimplex, CertifiesItsAnswerOnRandomSpheres) {
  for (const auto& [n, N] : {std::pair{2, 50}, {3, 400}, {7, 300}, {12, 60}}) {
    for (const Parameters& variant : kVariants) {
      SCOPED_TRACE("n = " + std::to_string(n) + " " + to_string(variant));
      const DistanceResult result = run(GetParam(), variant, two_spheres(7, n, N));
      EXPECT_EQ(result.status, DistanceStatus::optimal);
      EXPECT_LE(result.upper - result.lower, 1e-6 * result.upper);
      EXPECT_GE(result.distance, result.lower * (1 - 1e-6));
      EXPECT_LE(result.distance, result.upper * (1 + 1e-6));
      EXPECT_GT(result.counters.pivots, 0);
    }
  }
}

TEST_P(GlpkSimplex, NormalHasUnitGaugeAndGivesTheLowerBound) {
  const Instance sets = two_spheres(3, 5, 100);
  const DistanceResult result = run(GetParam(), {}, sets);
  EXPECT_NEAR(sets.Q->support_function(-result.normal), 1, 1e-14);
  EXPECT_NEAR(-sets.A->support_function(result.normal), result.lower, 1e-14 * result.lower);
}

TEST_P(GlpkSimplex, NeverCertifiesAWrongBoundBelowItsTolerances) {
  for (const ClosedForm& form : below_tolerances()) {
    SCOPED_TRACE(form.name);
    const DistanceResult result = run(GetParam(), {}, form.sets);
    EXPECT_FALSE(result.lower > form.distance);
    EXPECT_FALSE(result.upper < form.distance);
  }
}

TEST_P(GlpkSimplex, EverySolveStartsColdAndRepeatsItself) {
  const auto method = glpk_methods().make(GetParam(), {});
  method->load(two_spheres(1, 4, 200));
  method->solve({});
  const DistanceResult first = method->result();
  method->solve({});
  const DistanceResult second = method->result();
  EXPECT_EQ(first.distance, second.distance);
  EXPECT_EQ(first.counters, second.counters);
  EXPECT_EQ(first.lower, second.lower);
}

TEST_P(GlpkSimplex, ReportsATimeLimit) {
  const DistanceResult result = run(GetParam(), {}, two_spheres(1, 10, 20000), {1e-6, 1e-9});
  EXPECT_EQ(result.status, DistanceStatus::time_limit);
}

TEST_P(GlpkSimplex, AcceptsAnyToleranceOfARequest) {
  for (const double tolerance : {1e-300, 1e-12, 0.5, 1.0}) {
    const DistanceResult result = run(GetParam(), {}, two_spheres(2, 3, 100), {tolerance, kInf});
    EXPECT_EQ(result.status, DistanceStatus::optimal) << tolerance;
  }
}

TEST_P(GlpkSimplex, ThreadsAgreeWithSerialBitForBit) {
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

TEST_P(GlpkSimplex, FreesItsEnvironmentWithTheLastProblem) {
  const auto first = glpk_methods().make(GetParam(), {});
  first->load(two_spheres(1, 3, 1000));
  {
    const auto second = glpk_methods().make(GetParam(), {});
    second->load(two_spheres(2, 3, 1000));
    second->solve({});
    EXPECT_GT(allocated_bytes(), 100000u);
  }
  first->solve({});
  EXPECT_EQ(first->result().status, DistanceStatus::optimal) << "freed under a living problem";
}

TEST_P(GlpkSimplex, AnObjectMayOutliveItsThread) {
  std::unique_ptr<SolveMethod> method;
  std::thread([&] {
    method = glpk_methods().make(GetParam(), {});
    method->load(two_spheres(1, 3, 100));
    method->solve({});
  }).join();
  EXPECT_THROW(method->solve({}), Error);
  method->load(two_spheres(1, 3, 100));
  method->solve({});
  EXPECT_EQ(method->result().status, DistanceStatus::optimal);
}

TEST_P(GlpkSimplex, RefusesToSolveBeforeLoading) {
  const auto method = glpk_methods().make(GetParam(), {});
  EXPECT_THROW(method->solve({}), Error);
  EXPECT_THROW(method->result(), Error);
}

}  // namespace
}  // namespace raygauge::testing
