// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/glpk_simplex.h"

#include <glpk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "baselines/glpk_environment.h"
#include "tests/baselines/point_set_instances.h"

namespace raygauge::testing::test_glpk_simplex {
namespace {

std::unique_ptr<SolveMethod> make(const std::string& name, const Parameters& parameters = {}) {
  MethodRegistry registry("method");
  register_glpk_methods(registry);
  return registry.make(name, parameters);
}

/// Memory the GLPK environment of this thread holds. Asking makes an environment.
size_t allocated_bytes() {
  size_t bytes = 0;
  glp_mem_usage(nullptr, nullptr, &bytes, nullptr);
  return bytes;
}

class GlpkSimplex : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Both, GlpkSimplex, ::testing::Values("glpk_primal", "glpk_dual"),
                         [](const auto& method) { return std::string(method.param); });

TEST_P(GlpkSimplex, FreesItsEnvironmentWithTheLastProblem) {
  const auto first = make(GetParam());
  first->load(two_spheres(1, 3, 1000));
  {
    const auto second = make(GetParam());
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
    method = make(GetParam());
    method->load(two_spheres(1, 3, 100));
    method->solve({});
  }).join();
  EXPECT_THROW(method->solve({}), Error);
  method->load(two_spheres(1, 3, 100));
  method->solve({});
  EXPECT_EQ(method->result().status, DistanceStatus::optimal);
}

TEST_P(GlpkSimplex, WithoutMemoryHasAnAnswerWithoutBounds) {
  const GlpkProblem keeps_the_environment;
  glp_mem_limit(1);  // MiB
  const auto method = make(GetParam());
  method->load(two_spheres(1, 10, 20000));
  method->solve({});
  const DistanceResult result = method->result();
  EXPECT_EQ(result.status, DistanceStatus::precision_limit);
  EXPECT_FALSE(std::isfinite(result.upper));
  glp_mem_limit(std::numeric_limits<int>::max());
  method->load(two_spheres(1, 3, 100));
  method->solve({});
  EXPECT_EQ(method->result().status, DistanceStatus::optimal);
}

TEST_P(GlpkSimplex, SurvivesAnInternalErrorOfGlpk) {
  // Magnitudes whose ratio overflows: scaling ends in a failed assertion, at which GLPK calls abort().
  const Instance huge =
      instance(points({{1e308, 1e-308}, {1e-308, 1e308}}), points({{1e308, 1}, {1, 1e-308}}));
  const auto method = make(GetParam(), {{"scale", true}});
  method->load(huge);
  method->solve({});
  EXPECT_EQ(method->result().status, DistanceStatus::precision_limit);
  EXPECT_TRUE(std::isnan(method->result().distance));
  method->load(two_spheres(1, 3, 100));
  method->solve({});
  EXPECT_EQ(method->result().status, DistanceStatus::optimal);
}

}  // namespace
}  // namespace raygauge::testing::test_glpk_simplex
