// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/baselines/point_set_instances.h"

namespace raygauge::testing::test_baselines_registry {
namespace {

MethodRegistry baselines() {
  MethodRegistry registry("method");
  register_baselines(registry);
  return registry;
}

TEST(BaselinesRegistry, HoldsTheMethodsOfThisBuild) {
  std::vector<std::string> expected;
#ifdef RAYGAUGE_HAS_BULLET
  expected.emplace_back("bullet");
#endif
#ifdef RAYGAUGE_HAS_CGAL
  expected.emplace_back("cgal");
#endif
#ifdef RAYGAUGE_HAS_CLP
  expected.insert(expected.end(), {"clp_dual", "clp_primal"});
#endif
#ifdef RAYGAUGE_HAS_EXACT
  expected.emplace_back("exact");
#endif
#ifdef RAYGAUGE_HAS_FCL
  expected.insert(expected.end(), {"fcl_indep", "fcl_libccd"});
#endif
#ifdef RAYGAUGE_HAS_GLPK
  expected.insert(expected.end(), {"glpk_dual", "glpk_primal"});
#endif
#ifdef RAYGAUGE_HAS_LIBCCD
  expected.insert(expected.end(), {"libccd_gjk", "libccd_mpr"});
#endif
#ifdef RAYGAUGE_HAS_LIBSVM
  expected.emplace_back("libsvm_smo");
#endif
#ifdef RAYGAUGE_HAS_MUJOCO
  expected.emplace_back("mujoco");
#endif
#ifdef RAYGAUGE_HAS_NLOPT
  expected.emplace_back("nlopt_slsqp");
#endif
#ifdef RAYGAUGE_HAS_ODE
  expected.emplace_back("ode");
#endif
  EXPECT_EQ(baselines().names(), expected);
}

TEST(BaselinesRegistry, NoMethodHereIsOneOfTheEngines) {
  const MethodRegistry registry = baselines();
  for (const std::string& name : registry.names()) {
    EXPECT_EQ(registry.find(name).role, name == "exact" ? Role::oracle : Role::baseline) << name;
  }
}

TEST(BaselinesRegistry, NamesAVersionOfEverySolver) {
  for (const auto& [solver, version] : solver_versions()) {
    EXPECT_FALSE(version.empty()) << solver;
    EXPECT_NE(version.find('.'), std::string::npos) << solver << " " << version;
  }
}

TEST(BaselinesRegistry, EveryMethodAgreesOnRandomSpheres) {
  const MethodRegistry registry = baselines();
  for (const auto& [n, N] : {std::pair{2, 30}, {3, 200}, {5, 100}, {10, 60}}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Instance sets = two_spheres(seed, n, N);
      double highest_lower = 0, lowest_upper = std::numeric_limits<double>::infinity();
      for (const std::string& name : registry.names()) {
        if (!registry.find(name).point_sets) continue;
        const auto method = registry.make(name, {});
        method->load(sets);
        method->solve({});
        const DistanceResult result = method->result();
        EXPECT_EQ(to_string(result.status), "optimal") << name;
        EXPECT_LE(result.lower, result.upper) << name;
        highest_lower = std::max(highest_lower, result.lower);
        lowest_upper = std::min(lowest_upper, result.upper);
      }
      EXPECT_LE(highest_lower, lowest_upper) << "n = " << n << ", seed " << seed;
      EXPECT_LE(lowest_upper - highest_lower, 1e-6 * lowest_upper);
    }
  }
}

}  // namespace
}  // namespace raygauge::testing::test_baselines_registry
